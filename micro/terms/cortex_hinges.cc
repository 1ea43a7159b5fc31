#include "micro/terms/cortex_hinges.h"

#include "micro/geometry/triangle_hinge.h"
#include "micro/solve/motion_matrix.h"

#include <array>
#include <cmath>

namespace turgor {
namespace {
/// A hinge where it is now.
struct Bent {
  std::array<std::uint32_t, 4> nodes;
  Vector<3> g[4];  ///< 1/m
  double angle;    ///< rad

  Bent(const Particles<3> &p, const CellSurfaces::Edge &edge) : nodes{edge.a, edge.b, edge.c, edge.d} {
    const Vector<3> a = p.position(edge.a), b = p.position(edge.b), c = p.position(edge.c),
                    d = p.position(edge.d);
    const TriangleHinge hinge(a, b, c, d);
    hinge.gradient(a, b, c, d, g);
    angle = hinge.angle;
  }
};
}  // namespace

CortexHinges::CortexHinges(std::shared_ptr<CellSurfaces> surfaces_, const double stiffness_)
    : surfaces(std::move(surfaces_)), stiffness(stiffness_) {}

void CortexHinges::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  if (group >= surfaces->size()) return;
  const std::vector<double> &rest = surfaces->edge_table.column("rest_angle");
  const auto [begin, end] = surfaces->edges_of(group);
  for (std::uint32_t k = begin; k < end; ++k) {
    const Bent bent(particles, surfaces->edges[k]);
    const double moment = stiffness * std::sin(bent.angle - rest[k]);
    for (int m = 0; m < 4; ++m) add_force(particles, bent.nodes[m], -moment * bent.g[m]);
  }
}

void CortexHinges::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  if (h == 0.) return;
  const std::vector<double> &rest = surfaces->edge_table.column("rest_angle");
  for (std::size_t k = 0; k < surfaces->edges.size(); ++k) {
    const Bent bent(particles, surfaces->edges[k]);
    const double c = h * stiffness * std::cos(bent.angle - rest[k]);
    if (c > 0.) matrix.row<3>(bent.nodes, bent.g, c);
  }
}

double CortexHinges::energy(const Particles<3> &p, const Box<3> &, const std::size_t group) const {
  if (group >= surfaces->size()) return 0.;
  const std::vector<double> &rest = surfaces->edge_table.column("rest_angle");
  double total = 0.;
  const auto [begin, end] = surfaces->edges_of(group);
  for (std::uint32_t k = begin; k < end; ++k) {
    const CellSurfaces::Edge &edge = surfaces->edges[k];
    const TriangleHinge hinge(p.position(edge.a), p.position(edge.b), p.position(edge.c), p.position(edge.d));
    const double half =
        std::sin(0.5 * (hinge.angle - rest[k]));  // 1 - cos, with its digits where it is small
    total += 2. * stiffness * half * half;
  }
  return total;
}
}  // namespace turgor
