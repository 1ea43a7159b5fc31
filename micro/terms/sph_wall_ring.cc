#include "micro/terms/sph_wall_view.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// Area inside a closed ring run counterclockwise whose first node is repeated at its end, m^2.
double ring_area(const double *x, const double *y, const std::uint32_t n) {
  double twice = 0.;
  for (std::uint32_t k = 0; k < n; ++k)
    twice += (x[k] - x[0]) * (y[k + 1] - y[0]) - (x[k + 1] - x[0]) * (y[k] - y[0]);
  return 0.5 * twice;
}

std::size_t round_up(std::size_t n) { return (n + 7) / 8 * 8; }
std::size_t ring_size(const std::uint32_t nodes) { return round_up(2 * nodes + sph::list_padding + 1); }
std::size_t scratch_size(const WallArcs &arcs) { return std::size_t(4) * sph::list_padding * arcs.chunks; }
}  // namespace

template <>
WallView<2>::WallView(const WallArcs &lists_, const Group &group_, const WallSettings &settings_)
    : lists(lists_), group(group_), settings(settings_) {}

template <>
std::size_t WallView<2>::doubles() const {
  return scratch_size(lists) + 8 * ring_size(group.wall_count()) + 5 * round_up(lists.arcs.size());
}

template <>
void WallView<2>::attach(sph::CellView<2> &view, const Particles<2> &particles, double *memory) {
  const std::uint32_t nw = group.wall_count();
  const std::size_t scratch = scratch_size(lists), ring = ring_size(nw);
  view.n_wall = nw;
  view.arcs = lists.arcs.data();
  view.first_arc = lists.first_arc.data();
  view.scratch = memory;
  double *wall = memory + scratch;
  view.arc_ends = wall + 8 * ring;
  view.arc_stride = std::uint32_t(round_up(lists.arcs.size()));
  for (int d = 0; d < 2; ++d) {
    double *ring_x = wall + (4 * d) * ring, *ring_v = ring_x + ring, *ring_f = ring_v + ring,
           *ring_next = ring_f + ring;
    const double *x = particles.x[d].data() + group.begin, *v = particles.v[d].data() + group.begin;
    const std::size_t used = 2 * nw + sph::list_padding + 1;
    for (std::size_t k = 0, node = 0; k < used; ++k, node = node + 1 < nw ? node + 1 : 0) ring_x[k] = x[node];
    std::fill(ring_f, ring_f + 2 * ring, 0.);
    if (settings.viscous)
      for (std::size_t k = 0, node = 0; k < used; ++k, node = node + 1 < nw ? node + 1 : 0)
        ring_v[k] = v[node];
    view.wall_x[d] = ring_x;
    view.wall_v[d] = ring_v;
    view.wall_f[d] = ring_f;
    view.wall_f_next[d] = ring_next;
  }
  enclosed = settings.depth * ring_area(view.wall_x[0], view.wall_x[1], nw);
}

template <>
void WallView<2>::add_forces(const sph::CellView<2> &view, double *const (&f)[2]) const {
  const std::uint32_t nw = group.wall_count();
  const std::size_t used = 2 * nw + sph::list_padding;
  for (int d = 0; d < 2; ++d)
    for (std::size_t k = 0, node = 0; k < used; ++k) {
      f[d][node] += view.wall_f[d][k];
      node = node + 1 < nw ? node + 1 : 0;
      f[d][node] += view.wall_f_next[d][k];
    }
}

template <>
void WallView<2>::collect(const sph::CellView<2> &view, const double pressure,
                          Particles<2> &particles) const {
  const std::uint32_t nw = group.wall_count();
  const double push = 0.5 * pressure * settings.depth;  // times 2 dA/dx of a node
  for (int d = 0; d < 2; ++d) {
    double *f = particles.f[d].data() + group.begin;
    const double *across = view.wall_x[1 - d], sign = d == 0 ? push : -push;
    for (std::uint32_t k = 0; k < nw; ++k) f[k] += sign * (across[k + 1] - across[k > 0 ? k - 1 : nw - 1]);
  }
  double *const forces[2] = {particles.f[0].data() + group.begin, particles.f[1].data() + group.begin};
  add_forces(view, forces);
}

template <>
WallBulk WallView<2>::bulk(const Particles<2> &particles, const Group &g, const WallSettings &settings) {
  WallBulk result;
  const std::uint32_t n = g.wall_count();
  std::vector<double> x, y;
  double length = 0., squares = 0.;  // sums over the faces; |dA/dx_k|^2 is below their squares' mean
  for (std::uint32_t k = 0; k <= n; ++k) {
    const std::uint32_t node = g.begin + k % n;
    x.push_back(particles.x[0][node]);
    y.push_back(particles.x[1][node]);
    const double face = k > 0 ? std::hypot(x[k] - x[k - 1], y[k] - y[k - 1]) : 0.;
    length += face;
    squares += face * face;
  }
  result.volume = settings.depth * ring_area(x.data(), y.data(), n);
  result.slopes_squared = settings.depth * settings.depth * squares;
  result.node_area = settings.depth * (length / n);
  return result;
}
}  // namespace turgor
