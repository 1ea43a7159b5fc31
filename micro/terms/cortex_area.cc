#include "micro/terms/cortex_area.h"

#include "micro/solve/motion_matrix.h"

#include <Eigen/Geometry>

namespace turgor {
namespace {
/// A triangle where it is now.
struct Facet {
  double area;     ///< m^2
  Vector<3> n;     ///< its normal
  Vector<3> g[3];  ///< d area/dx, m

  Facet(const Particles<3> &p, const CellSurfaces::Triangle &nodes) {
    const Vector<3> x[3] = {p.position(nodes[0]), p.position(nodes[1]), p.position(nodes[2])};
    const Vector<3> twice = twice_area(x[0], x[1], x[2]);
    const double size = twice.norm();
    area = 0.5 * size;
    n = twice / size;
    for (int k = 0; k < 3; ++k) g[k] = 0.5 * n.cross(x[(k + 2) % 3] - x[(k + 1) % 3]);
  }
};
}  // namespace

CortexArea::CortexArea(std::shared_ptr<CellSurfaces> surfaces_, const AreaStiffness &stiffness_)
    : surfaces(std::move(surfaces_)), stiffness(stiffness_) {}

double CortexArea::of_whole(const Particles<3> &particles, const std::size_t group) const {
  if (stiffness.whole == 0.) return 0.;
  const double rest = surfaces->cells.column("rest_area")[group];
  return stiffness.whole * (surfaces->area(particles, group) - rest) / rest;
}

void CortexArea::prepare(const Particles<3> &, const Box<3> &, unsigned int, bool) {
  energy_of.resize(surfaces->size());
}

void CortexArea::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  if (group >= surfaces->size()) return;
  const std::vector<double> &rest = surfaces->triangle_table.column("rest_area");
  const double same = stiffness.tension + of_whole(particles, group);
  double local = 0., area = 0.;
  const auto [begin, end] = surfaces->triangles_of(group);
  for (std::uint32_t k = begin; k < end; ++k) {
    const Facet facet(particles, surfaces->triangles[k]);
    const double out = facet.area - rest[k], sigma = stiffness.local * out / rest[k] + same;
    for (int m = 0; m < 3; ++m) add_force(particles, surfaces->triangles[k][m], -sigma * facet.g[m]);
    local += 0.5 * stiffness.local * out * out / rest[k];
    area += facet.area;
  }
  const double whole = surfaces->cells.column("rest_area")[group];
  energy_of[group] =
      local + stiffness.tension * area + 0.5 * stiffness.whole * (area - whole) * (area - whole) / whole;
}

void CortexArea::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  if (h == 0.) return;
  const std::vector<double> &rest = surfaces->triangle_table.column("rest_area");
  for (std::size_t cell = 0; cell < surfaces->size(); ++cell) {
    const double same = stiffness.tension + of_whole(particles, cell);
    const Group &group = particles.groups[cell];
    std::vector<Vector<3>> G(stiffness.whole > 0. ? group.wall_count() : 0, Vector<3>::Zero());
    const auto [begin, end] = surfaces->triangles_of(cell);
    for (std::uint32_t k = begin; k < end; ++k) {
      const CellSurfaces::Triangle &nodes = surfaces->triangles[k];
      const Facet facet(particles, nodes);
      if (stiffness.local > 0.) matrix.row<3>(nodes, facet.g, h * stiffness.local / rest[k]);
      if (!G.empty())
        for (int m = 0; m < 3; ++m) G[nodes[m] - group.begin] += facet.g[m];
      const double sigma = stiffness.local * (facet.area - rest[k]) / rest[k] + same;
      if (!(sigma > 0.)) continue;
      // grad w = sum of w_k grad b_k, grad b_k = -g_k/a: one row for each of its two components in the plane
      const Vector<3> t = facet.g[0].normalized(), across[2] = {t, facet.n.cross(t)};
      for (const Vector<3> &direction : across) {
        Vector<3> row[3];
        for (int m = 0; m < 3; ++m) row[m] = facet.g[m].dot(direction) * facet.n;
        matrix.row<3>(nodes, row, h * sigma / facet.area);
      }
    }
    if (!G.empty())
      matrix.whole<3>(group.begin, G, h * stiffness.whole / surfaces->cells.column("rest_area")[cell]);
  }
}

double CortexArea::energy(const Particles<3> &, const Box<3> &, const std::size_t group) const {
  return group < surfaces->size() ? energy_of[group] : 0.;
}

double CortexArea::slope_of_growth(const Particles<3> &particles, const std::size_t cell) const {
  const std::vector<double> &rest = surfaces->triangle_table.column("rest_area");
  double local = 0., area = 0.;
  const auto [begin, end] = surfaces->triangles_of(cell);
  for (std::uint32_t k = begin; k < end; ++k) {
    const double a = Facet(particles, surfaces->triangles[k]).area;
    local += (a * a - rest[k] * rest[k]) / rest[k];
    area += a;
  }
  const double whole = surfaces->cells.column("rest_area")[cell];
  return -stiffness.local * local - stiffness.whole * (area * area - whole * whole) / whole;
}
}  // namespace turgor
