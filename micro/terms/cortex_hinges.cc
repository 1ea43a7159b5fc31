#include "micro/terms/cortex_hinges.h"

#include "micro/geometry/triangle_hinge.h"
#include "micro/solve/motion_matrix.h"

#include <array>
#include <cmath>

namespace turgor {
CortexHinges::CortexHinges(std::shared_ptr<CellSurfaces> surfaces_, const double stiffness_)
    : surfaces(std::move(surfaces_)), stiffness(stiffness_) {}

void CortexHinges::prepare(const Particles<3> &, const Box<3> &, unsigned int, bool) {
  softness.resize(surfaces->edges.size());
  energy_of.resize(surfaces->size());
  const std::vector<double> &rest = surfaces->edge_table.column("rest_angle");
  if (rest == rest_angle) return;
  rest_angle = rest;
  at_rest.resize(rest.size());
  for (std::size_t k = 0; k < rest.size(); ++k) at_rest[k] = {std::sin(rest[k]), std::cos(rest[k])};
}

void CortexHinges::add_forces(Particles<3> &p, const Box<3> &, const std::size_t group) {
  if (group >= surfaces->size()) return;
  const auto [begin, end] = surfaces->edges_of(group);
  double total = 0.;
  for (std::uint32_t k = begin; k < end; ++k) {
    const auto &[i, j, l, m] = surfaces->edges[k];
    const Vector<3> a = p.position(i), b = p.position(j), c = p.position(l), d = p.position(m);
    const HingeSlope hinge(a, b, c, d);
    Vector<3> g[4];
    hinge.gradient(a, b, c, d, g);
    // sin and cos of how far it is bent from its rest: angles themselves take longest
    const double sine = hinge.sine(), cosine = hinge.cosine(),
                 unit = 1. / std::sqrt(sine * sine + cosine * cosine),
                 moment = unit * (sine * at_rest[k].cosine - cosine * at_rest[k].sine),
                 straight = unit * (cosine * at_rest[k].cosine + sine * at_rest[k].sine);
    // 1 - cos, with its digits where it is small
    softness[k] = straight > 0. ? moment * moment / (1. + straight) : 1. - straight;
    total += softness[k];
    const std::uint32_t nodes[4] = {i, j, l, m};
    for (int n = 0; n < 4; ++n) add_force(p, nodes[n], -stiffness * moment * g[n]);
  }
  energy_of[group] = stiffness * total;
}

void CortexHinges::collect(MotionMatrix &matrix, const Particles<3> &p, const double h) {
  if (h == 0.) return;
  for (std::size_t k = 0; k < surfaces->edges.size(); ++k) {
    const double cosine = 1. - softness[k];
    if (!(cosine > 0.)) continue;
    const auto &[i, j, l, m] = surfaces->edges[k];
    const Vector<3> a = p.position(i), b = p.position(j), c = p.position(l), d = p.position(m);
    Vector<3> g[4];
    HingeSlope(a, b, c, d).gradient(a, b, c, d, g);
    matrix.row<3>(std::array<std::uint32_t, 4>{i, j, l, m}, g, h * stiffness * cosine);
  }
}

double CortexHinges::energy(const Particles<3> &, const Box<3> &, const std::size_t group) const {
  return group < surfaces->size() ? energy_of[group] : 0.;
}
}  // namespace turgor
