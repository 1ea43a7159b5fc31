#include "micro/terms/sph_wall_view.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace turgor {
namespace {
std::size_t round_up(std::size_t n) { return (n + 7) / 8 * 8; }

/// Volume, m^3, and (slopes, 4 doubles a node, added to) six times its derivatives, m^2. Places are taken
/// from the first node: smaller numbers, and the same derivatives, for the mesh is closed.
double add_volume(const TriangleMesh &mesh, const double *rows, double *slopes) {
  const auto at = [&](const std::uint16_t k) {
    return Vector<3>(rows[4 * k] - rows[0], rows[4 * k + 1] - rows[1], rows[4 * k + 2] - rows[2]);
  };
  double six = 0.;
  for (const auto &face : mesh.faces) {
    const Vector<3> a = at(face[0]), b = at(face[1]), c = at(face[2]), bxc = b.cross(c), cxa = c.cross(a),
                    axb = a.cross(b);
    six += a.dot(bxc);
    for (int d = 0; d < 3; ++d) {
      slopes[4 * face[0] + d] += bxc[d];
      slopes[4 * face[1] + d] += cxa[d];
      slopes[4 * face[2] + d] += axb[d];
    }
  }
  return six / 6.;
}
}  // namespace

template <>
WallView<3>::WallView(const WallFaces &lists_, const Group &group_, const WallSettings &settings_)
    : lists(lists_), group(group_), settings(settings_) {}

template <>
std::size_t WallView<3>::doubles() const {
  // Wall: positions, velocities, forces, slopes. Fluid: places, pulls. Rims; what is kept of the faces.
  return round_up(4 * std::size_t(group.wall_count())) * 4 +
         round_up(4 * (std::size_t(group.fluid_count()) + 1)) * 2 + 4 * lists.rim_nodes.size() +
         8 * (round_up(lists.longest) + 2 * sph::list_padding) + lists.kept + round_up(lists.faces.size()) +
         (settings.viscous ? 6 * lists.particles.size() : 0);
}

template <>
void WallView<3>::attach(sph::CellView<3> &view, const Particles<3> &particles, double *memory) {
  const std::uint32_t nw = group.wall_count();
  const std::size_t rows = round_up(4 * std::size_t(nw)),
                    fluid = round_up(4 * (std::size_t(group.fluid_count()) + 1));
  double *x = memory, *v = x + rows, *f = v + rows, *slope = f + rows;
  view.n_wall = nw;
  view.wall_x = x;
  view.wall_v = v;
  view.wall_f = f;
  view.own = slope + rows;
  view.pull = view.own + fluid;
  view.rim_pull = view.pull + fluid;
  view.rim_scratch = view.rim_pull + 4 * lists.rim_nodes.size();
  view.kept = view.rim_scratch + 8 * (round_up(lists.longest) + 2 * sph::list_padding);
  view.active = reinterpret_cast<std::uint16_t *>(view.kept + lists.kept);
  view.kept_rays = view.kept + lists.kept + round_up(lists.faces.size());
  view.corners = settings.mesh->faces.data()->data();
  view.face_lists = lists.faces.data();
  view.n_faces = std::uint32_t(lists.faces.size());
  view.face_particles = lists.particles.data();
  view.rims = lists.rims.data();
  view.n_rims = std::uint32_t(lists.rims.size());
  view.rim_nodes = lists.rim_nodes.data();
  view.toward = lists.toward.data();
  view.doubts = lists.doubts.data();
  view.n_doubts = std::uint32_t(lists.doubts.size());
  std::fill(f, f + rows, 0.);
  std::fill(slope, slope + rows, 0.);
  for (std::uint32_t k = 0; k < nw; ++k)
    for (int d = 0; d < 4; ++d) {
      x[4 * k + d] = d < 3 ? particles.x[d][group.begin + k] : 0.;
      if (settings.viscous) v[4 * k + d] = d < 3 ? particles.v[d][group.begin + k] : 0.;
    }
  enclosed = add_volume(*settings.mesh, x, slope);
  slopes = slope;
}

template <>
void WallView<3>::add_forces(const sph::CellView<3> &view, double *const (&f)[3]) const {
  for (int d = 0; d < 3; ++d)
    for (std::uint32_t k = 0; k < group.wall_count(); ++k) f[d][k] += view.wall_f[4 * k + d];
}

template <>
void WallView<3>::collect(const sph::CellView<3> &view, const double pressure,
                          Particles<3> &particles) const {
  for (int d = 0; d < 3; ++d) {
    double *f = particles.f[d].data() + group.begin;
    for (std::uint32_t k = 0; k < group.wall_count(); ++k)
      f[k] += view.wall_f[4 * k + d] + pressure * (1. / 6.) * slopes[4 * k + d];
  }
}

template <>
WallBulk WallView<3>::bulk(const Particles<3> &particles, const Group &g, const WallSettings &settings) {
  WallBulk result;
  const std::uint32_t n = g.wall_count();
  std::vector<double> rows(4 * n), slope(4 * n, 0.);
  for (std::uint32_t k = 0; k < n; ++k)
    for (int d = 0; d < 3; ++d) rows[4 * k + d] = particles.x[d][g.begin + k];
  result.volume = add_volume(*settings.mesh, rows.data(), slope.data());
  for (const double s : slope) result.slopes_squared += s * s / 36.;
  result.node_area = settings.mesh->area(particles.x[0].data() + g.begin, particles.x[1].data() + g.begin,
                                         particles.x[2].data() + g.begin) /
                     n;
  return result;
}
}  // namespace turgor
