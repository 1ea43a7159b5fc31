#include "micro/cells/mean_traction.h"

#include "micro/cells/ring_geometry.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace turgor {
namespace {
double product(const Tensor2<2> &a, const Tensor2<2> &b) { return (a.array() * b.array()).sum(); }

/// Linear in F in two dimensions.
Tensor2<2> cofactor(const Tensor2<2> &F) {
  Tensor2<2> K;
  K << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  return K;
}

std::vector<std::uint32_t> ring_of_nodes(const CellLayout &layout) {
  std::vector<std::uint32_t> ring(layout.nodes.size());
  for (std::uint32_t c = 0; c < layout.rings.size(); ++c)
    for (std::size_t i = layout.rings[c].first; i < layout.rings[c].end(); ++i) ring[i] = c;
  return ring;
}
}  // namespace

bool is_cut(const LamellaTie &tie) { return tie.shift[0] != 0 || tie.shift[1] != 0; }

CellLayout without_cut_ties(CellLayout layout) {
  std::erase_if(layout.ties, is_cut);
  return layout;
}

std::vector<std::uint32_t> boundary_nodes(const CellLayout &layout) {
  std::set<std::uint32_t> nodes;
  for (const LamellaTie &tie : layout.ties)
    if (is_cut(tie)) nodes.insert({tie.a, tie.b});
  return {nodes.begin(), nodes.end()};
}

MeanTraction::MeanTraction(const CellLayout &reference) {
  const Tensor2<2> &H = reference.lattice;
  const double depth = reference.parameters.depth;
  const std::vector<std::uint32_t> ring = ring_of_nodes(reference);
  // Nodes of one side of a cut: those of one cell that meet one image of another.
  using Side = std::tuple<std::uint32_t, std::uint32_t, int, int>;
  const auto side = [&](const LamellaTie &tie) {
    return Side(ring[tie.a], ring[tie.b], tie.shift[0], tie.shift[1]);
  };
  std::map<Side, std::set<std::uint32_t>> sides;
  for (const LamellaTie &tie : reference.ties)
    if (is_cut(tie)) sides[side(tie)].insert(tie.a);
  for (Tensor2<2> *sum : {&G, &C, &D, &M}) sum->setZero();
  for (const LamellaTie &tie : reference.ties) {
    if (!is_cut(tie)) continue;
    const std::set<std::uint32_t> &same = sides.at(side(tie));
    const WallRing &of_a = reference.rings[ring[tie.a]];
    Vector<2> along = Vector<2>::Zero();  // half of the bonds of this side at a, counter-clockwise
    if (const std::size_t next = of_a.after(tie.a); same.count(std::uint32_t(next)))
      along += 0.5 * (reference.nodes[next] - reference.nodes[tie.a]);
    if (const std::size_t before = of_a.before(tie.a); same.count(std::uint32_t(before)))
      along += 0.5 * (reference.nodes[tie.a] - reference.nodes[before]);
    const Vector<2> area(depth * along[1], -depth * along[0]);
    const Vector<2> force = LamellaSpring{tie.stiffness}.force_on_a(
        LamellaSpring::gap(reference.nodes[tie.a], reference.nodes[tie.b], tie.shift, H));
    const double soft = 0.5 / tie.stiffness;
    for (const double sign : {1., -1.}) {
      all.push_back({sign > 0. ? tie.a : tie.b, sign * area, sign * force});
      C += soft * force * area.transpose();
      D += soft * force * force.transpose();
      M += soft * area * area.transpose();
    }
    G += (H.col(0) * tie.shift[0] + H.col(1) * tie.shift[1]) * area.transpose();
  }
  H0_inverse = H.inverse();
  M_inverse = M.inverse();
}

struct MeanTraction::At {
  Tensor2<2> F, K, B = Tensor2<2>::Zero(), X = Tensor2<2>::Zero(), P;
};

MeanTraction::At MeanTraction::at(const std::vector<double> &x, const Tensor2<2> &H) const {
  At now;
  now.F = H * H0_inverse;
  now.K = cofactor(now.F);
  for (const End &end : all) {
    now.B += turgor::at(x, end.node) * end.area.transpose();
    now.X += turgor::at(x, end.node) * end.force.transpose();
  }
  now.P = (now.F * G - now.B - now.K * C) * M_inverse;
  return now;
}

double MeanTraction::energy(const std::vector<double> &x, const Tensor2<2> &H) const {
  const At now = at(x, H);
  return 0.5 * product(now.P, now.P * M) - product(now.K, now.X) - 0.5 * product(now.K, now.K * D);
}

Tensor2<2> MeanTraction::add_gradient(const std::vector<double> &x, const Tensor2<2> &H,
                                      std::vector<double> &gradient) const {
  const At now = at(x, H);
  for (const End &end : all) {
    const Vector<2> force = now.K * end.force + now.P * end.area;
    for (int a = 0; a < 2; ++a) gradient[2 * end.node + a] -= force[a];
  }
  Tensor2<2> virial;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      Tensor2<2> L = Tensor2<2>::Zero();
      L(a, b) = 1.;
      const Tensor2<2> dK = cofactor(L * now.F);
      virial(a, b) = product(now.P, L * (now.F * G - now.B) - dK * C) - product(dK, now.X) -
                     product(now.K, L * now.X) - product(dK, now.K * D);
    }
  return virial;
}

void MeanTraction::add_affine_response(const std::vector<double> &x, const Tensor2<2> &H,
                                       const std::array<Tensor2<2>, 4> &L,
                                       std::array<std::vector<double>, 4> &forces,
                                       Tensor4<2> &curvature) const {
  const At now = at(x, H);
  std::array<Tensor2<2>, 4> dK, dW;  // by each motion; all are linear in how far it goes
  for (int k = 0; k < 4; ++k) {
    dK[k] = cofactor(L[k] * now.F);
    dW[k] = L[k] * (now.F * G - now.B) - dK[k] * C;
    const Tensor2<2> dP = dW[k] * M_inverse;
    for (const End &end : all) {
      const Vector<2> force = dK[k] * end.force + dP * end.area;
      for (int a = 0; a < 2; ++a) forces[k][2 * end.node + a] -= force[a];
    }
  }
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l)
      curvature(k, l) += product(dW[k] * M_inverse, dW[l]) - product(dK[k], L[l] * now.X) -
                         product(dK[l], L[k] * now.X) - product(dK[k], dK[l] * D);
}
}  // namespace turgor
