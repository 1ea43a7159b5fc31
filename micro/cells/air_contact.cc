#include "micro/cells/air_contact.h"

#include "micro/cells/ring_geometry.h"

#include <algorithm>

namespace turgor {
namespace {
constexpr double contact_ratio =
    1.;  // more is no better: bricks pressed flat then find no rest (see the header)
}

FaceContact AirContact::law_of(const CellLayout &layout) {
  FaceContact law;
  law.inset = std::min(layout.parameters.wall_thickness, 0.2 * layout.spacing);
  law.smooth = 0.25 * layout.spacing;
  law.range = 1.6 * law.inset;
  law.stiffness = contact_ratio * layout.spring_stiffness / law.range;
  return law;
}

AirContact::AirContact(const CellLayout &layout) : contact(law_of(layout)) {
  for (const AirSpace &air : layout.air) {
    Space space;
    for (const AirFace &face : air) {
      const WallRing &ring = layout.rings[face.ring];
      space.first.push_back(std::uint32_t(space.nodes.size()));
      std::size_t node = ring.before(face.first);
      for (std::uint32_t k = 0; k < face.bonds + 3; ++k, node = ring.after(node))
        space.nodes.push_back({std::uint32_t(node), face.shift});
    }
    space.first.push_back(std::uint32_t(space.nodes.size()));
    spaces.push_back(std::move(space));
  }
}

template <class What>
void AirContact::touching(const std::vector<double> &x, const Tensor2<2> &H, const What &what) const {
  std::vector<Vector<2>> place, y;
  for (std::uint32_t s = 0; s < spaces.size(); ++s) {
    const Space &space = spaces[s];
    place.clear();
    for (const Node &n : space.nodes)
      place.push_back(at(x, n.node) + H.col(0) * double(n.shift[0]) + H.col(1) * double(n.shift[1]));
    y.assign(place.size(), Vector<2>::Zero());
    const std::size_t faces = space.first.size() - 1;
    for (std::size_t f = 0; f < faces; ++f)
      for (std::uint32_t i = space.first[f] + 1; i + 1 < space.first[f + 1]; ++i)
        y[i] = contact.face(place[i - 1], place[i], place[i + 1]);
    for (std::size_t f = 0; f < faces; ++f)
      for (std::uint32_t i = space.first[f] + 2; i + 2 < space.first[f + 1]; ++i)  // those that are not tied
        for (std::size_t g = 0; g < faces; ++g) {
          if (g == f) continue;
          const std::uint32_t begin = space.first[g] + 1, corners = space.first[g + 1] - 1 - begin;
          const FaceContact::Foot foot = FaceContact::nearest(y[i], &y[begin], corners);
          if (foot.distance < contact.range) what(s, place, i, begin + std::uint32_t(foot.bond), foot);
        }
  }
}

void AirContact::find(const std::vector<double> &x, const Tensor2<2> &H, const bool with_hessian,
                      std::vector<AirTouch> &touches) const {
  touches.clear();
  touching(x, H,
           [&](const std::uint32_t space, const std::vector<Vector<2>> &place, const std::uint32_t i,
               const std::uint32_t j, const FaceContact::Foot &foot) {
             AirTouch &touch = touches.emplace_back();
             touch.space = space;
             touch.local = {i - 1, i, i + 1, j - 1, j, j + 1, j + 2};
             for (std::size_t k = 0; k < 7; ++k) touch.places[k] = place[touch.local[k]];
             touch.foot = foot;
             contact.derivatives(touch.places, foot, touch.gradient, with_hessian ? &touch.hessian : nullptr);
           });
}

double AirContact::energy(const std::vector<double> &x, const Tensor2<2> &H) const {
  double sum = 0.;
  touching(x, H,
           [&](const std::uint32_t, const std::vector<Vector<2>> &, const std::uint32_t, const std::uint32_t,
               const FaceContact::Foot &foot) { sum += contact.energy(foot.distance); });
  return sum;
}

void AirContact::add_forces(const std::vector<AirTouch> &touches, std::vector<double> &gradient,
                            Tensor2<2> &virial) const {
  for (const AirTouch &touch : touches)
    for (std::size_t k = 0; k < 7; ++k) {
      const Vector<2> G = touch.gradient.segment<2>(Eigen::Index(2 * k));
      const std::uint32_t node = nodes(touch.space)[touch.local[k]].node;
      gradient[2 * node] += G[0];
      gradient[2 * node + 1] += G[1];
      // the forces of a contact are in balance: places count from the point
      virial += G * (touch.places[k] - touch.places[1]).transpose();
    }
}

void AirContact::add_affine(const std::vector<AirTouch> &touches, const std::array<Tensor2<2>, 4> &L,
                            std::array<std::vector<double>, 4> &forces, Tensor4<2> &curvature) const {
  Eigen::Matrix<double, 14, 4> moved;
  for (const AirTouch &touch : touches) {
    for (std::size_t k = 0; k < 7; ++k)
      for (std::size_t m = 0; m < 4; ++m)
        moved.block<2, 1>(Eigen::Index(2 * k), Eigen::Index(m)) = L[m] * (touch.places[k] - touch.places[1]);
    const Eigen::Matrix<double, 14, 4> change = touch.hessian * moved;
    curvature += moved.transpose() * change;
    for (std::size_t k = 0; k < 7; ++k) {
      const std::uint32_t node = nodes(touch.space)[touch.local[k]].node;
      for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t d = 0; d < 2; ++d)
          forces[m][2 * node + d] += change(Eigen::Index(2 * k + d), Eigen::Index(m));
    }
  }
}
}  // namespace turgor
