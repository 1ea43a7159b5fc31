#include "micro/cells/air_gas.h"

#include "micro/cells/ring_geometry.h"

#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
/// d2A/dX_k dX_next of the area of a clockwise rim.
Tensor2<2> turn() {
  Tensor2<2> half;
  half << 0., -0.5, 0.5, 0.;
  return half;
}
}  // namespace

AirGas::AirGas(const AirContact &contact, const AirGasLaw &law_, const double depth_)
    : law(law_), depth(depth_) {
  if (!(law.outside >= 0.) || !(law.exponent >= 1.))
    throw std::invalid_argument(
        "Gas in air spaces needs a pressure of 0 or more and an exponent of 1 or more.");
  if (law.outside == 0.) return;
  for (std::size_t s = 0; s < contact.size(); ++s) {
    Space space;
    const std::vector<AirContact::Node> &nodes = contact.nodes(s);
    const std::vector<std::uint32_t> &first = contact.faces(s);
    for (std::size_t f = 0; f + 1 < first.size(); ++f)
      for (std::uint32_t i = first[f] + 1; i + 1 < first[f + 1]; ++i)  // without the one more at either end
        space.rim.push_back({nodes[i].node, nodes[i].shift, i});
    spaces.push_back(std::move(space));
  }
}

void AirGas::place(const Space &space, const std::vector<double> &x, const Tensor2<2> &H,
                   std::vector<Vector<2>> &places) const {
  places.clear();
  for (const Node &n : space.rim)
    places.push_back(at(x, n.node) + H.col(0) * double(n.shift[0]) + H.col(1) * double(n.shift[1]));
}

double AirGas::area_of(const std::vector<Vector<2>> &places) {
  double twice = 0.;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vector<2> here = places[k] - places[0], next = places[(k + 1) % places.size()] - places[0];
    twice += here[1] * next[0] - here[0] * next[1];
  }
  return 0.5 * twice;
}

void AirGas::shut(const std::vector<double> &x, const Tensor2<2> &H) {
  std::vector<Vector<2>> places;
  for (Space &space : spaces) {
    place(space, x, H, places);
    space.area = area_of(places);
    if (!(space.area > 0.))
      throw std::invalid_argument(
          "An air space of this tissue has no area at rest, so that no air can be shut in it. Use "
          "Structure/Air = connected or a larger Structure/Gap.");
  }
}

double AirGas::energy(const std::vector<double> &x, const Tensor2<2> &H) const {
  double sum = 0.;
  std::vector<Vector<2>> places;
  for (const Space &space : spaces) {
    place(space, x, H, places);
    const double area = area_of(places);
    if (!(area > 0.)) return HUGE_VAL;
    const double ratio = space.area / area, above = law.exponent - 1.;
    const double g = above > 0. ? std::expm1(above * std::log(ratio)) / above : std::log(ratio);
    sum += law.outside * depth * (space.area * g + area - space.area);
  }
  return sum;
}

void AirGas::find(const std::vector<double> &x, const Tensor2<2> &H, std::vector<AirPush> &pushes) const {
  pushes.resize(spaces.size());
  for (std::size_t s = 0; s < spaces.size(); ++s) {
    AirPush &push = pushes[s];
    place(spaces[s], x, H, push.places);
    const double area = area_of(push.places),
                 absolute = law.outside * std::pow(spaces[s].area / area, law.exponent);
    push.pressure = absolute - law.outside;
    push.stiffness = law.exponent * absolute * depth / area;
    const std::size_t n = push.places.size();
    push.slope.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const Vector<2> along = push.places[(k + 1) % n] - push.places[(k + n - 1) % n];
      push.slope[k] = turn() * along;
    }
  }
}

Tensor2<2> AirGas::hessian(const AirPush &push, const std::size_t a, const std::size_t b) const {
  Tensor2<2> result = push.stiffness * push.slope[a] * push.slope[b].transpose();
  const std::size_t n = push.places.size();
  if ((a + 1) % n == b) result -= push.pressure * depth * turn();
  if ((b + 1) % n == a) result += push.pressure * depth * turn();  // its transpose
  return result;
}

void AirGas::add_forces(const std::vector<AirPush> &pushes, std::vector<double> &gradient,
                        Tensor2<2> &virial) const {
  for (std::size_t s = 0; s < spaces.size(); ++s)
    for (std::size_t k = 0; k < spaces[s].rim.size(); ++k) {
      const Vector<2> G = -pushes[s].pressure * depth * pushes[s].slope[k];
      const std::uint32_t node = spaces[s].rim[k].node;
      gradient[2 * node] += G[0];
      gradient[2 * node + 1] += G[1];
      // the pushes on a rim are in balance: places count from its first node
      virial += G * (pushes[s].places[k] - pushes[s].places[0]).transpose();
    }
}

void AirGas::add_affine(const std::vector<AirPush> &pushes, const std::array<Tensor2<2>, 4> &L,
                        std::array<std::vector<double>, 4> &forces, Tensor4<2> &curvature) const {
  using Rows = Eigen::Matrix<double, 2, 4>;  // column m: what motion L[m] does
  for (std::size_t s = 0; s < spaces.size(); ++s) {
    const AirPush &push = pushes[s];
    const std::size_t n = push.places.size();
    std::vector<Rows> moved(n);
    Eigen::Matrix<double, 1, 4> rise = Eigen::Matrix<double, 1, 4>::Zero();  // of the area
    for (std::size_t k = 0; k < n; ++k) {
      for (int m = 0; m < 4; ++m) moved[k].col(m) = L[std::size_t(m)] * (push.places[k] - push.places[0]);
      rise += push.slope[k].transpose() * moved[k];
    }
    for (std::size_t k = 0; k < n; ++k) {
      const Rows change = push.stiffness * push.slope[k] * rise -
                          push.pressure * depth * turn() * (moved[(k + 1) % n] - moved[(k + n - 1) % n]);
      curvature += moved[k].transpose() * change;
      for (int m = 0; m < 4; ++m)
        for (int d = 0; d < 2; ++d)
          forces[std::size_t(m)][2 * spaces[s].rim[k].node + std::size_t(d)] += change(d, m);
    }
  }
}
}  // namespace turgor
