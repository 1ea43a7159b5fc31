// CellContact, which points are near which bonds: rings and, in a periodic box, their images.
#include "micro/terms/cell_contact.h"

#include "micro/geometry/bins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor {
/// Middles of the bonds that hold, images behind them.
struct CellContact::Bonds {
  std::vector<double> middle[2];                                        ///< m
  std::vector<std::uint32_t> node, ring;                                ///< the bond's first node
  std::vector<std::array<int, 2>> shift;                                ///< periods
  double lo[2] = {HUGE_VAL, HUGE_VAL}, hi[2] = {-HUGE_VAL, -HUGE_VAL};  ///< m, the box of the middles
  double range = 0., reach = 0.;  ///< m, of a point to a bond and to its middle

  void add(const double *m, const std::uint32_t node_, const std::uint32_t ring_,
           const std::array<int, 2> &periods) {
    for (int d = 0; d < 2; ++d) {
      lo[d] = std::min(lo[d], m[d]);
      hi[d] = std::max(hi[d], m[d]);
      middle[d].push_back(m[d]);
    }
    node.push_back(node_);
    ring.push_back(ring_);
    shift.push_back(periods);
  }
};

CellContact::Bonds CellContact::bonds_and_images() const {
  Bonds all;
  double longest2 = 0.;
  for (std::size_t c = 0; c < groups.size(); ++c)
    for (std::uint32_t k = groups[c].begin; k < groups[c].fluid; ++k) {
      const std::uint32_t next = wall_node_after(groups[c], k);
      const double ex = origin[0][next] - origin[0][k], ey = origin[1][next] - origin[1][k];
      if ((damage && damage->cells[c].bond_broken[k - groups[c].begin]) ||
          !(std::abs(ex) + std::abs(ey) < 1e300))
        continue;
      longest2 = std::max(longest2, ex * ex + ey * ey);
      const double m[2] = {0.5 * (origin[0][k] + origin[0][next]), 0.5 * (origin[1][k] + origin[1][next])};
      all.add(m, k, std::uint32_t(c), {0, 0});
    }
  all.range = std::max(parameters.range, parameters.fluid_range) + parameters.skin;
  all.reach = all.range + 0.5 * std::sqrt(longest2);
  if (!(box.periodic[0] || box.periodic[1]) || all.node.empty()) return all;

  // Images that lie within reach of the box of all points.
  double lo[2] = {all.lo[0], all.lo[1]}, hi[2] = {all.hi[0], all.hi[1]};
  for (std::size_t c = 0; c < groups.size(); ++c)
    for (std::uint32_t i = groups[c].begin; i < points_end(c); ++i)
      if (std::abs(origin[0][i]) + std::abs(origin[1][i]) < 1e300)
        for (int d = 0; d < 2; ++d) {
          lo[d] = std::min(lo[d], origin[d][i] - all.reach);
          hi[d] = std::max(hi[d], origin[d][i] + all.reach);
        }
  const Tensor2<2> inverse = box.H.inverse();
  int most[2] = {0, 0};
  for (int d = 0; d < 2; ++d)
    if (box.periodic[d])
      most[d] =
          int(std::min(100., std::floor(std::hypot(hi[0] - lo[0], hi[1] - lo[1]) * inverse.row(d).norm())));
  const std::size_t own = all.node.size();
  for (int a = -most[0]; a <= most[0]; ++a)
    for (int b = -most[1]; b <= most[1]; ++b)
      if (a != 0 || b != 0)
        for (std::size_t i = 0; i < own; ++i) {
          const Vector<2> m = Vector<2>(all.middle[0][i], all.middle[1][i]) + box.image({a, b});
          if (m[0] > lo[0] && m[0] < hi[0] && m[1] > lo[1] && m[1] < hi[1])
            all.add(m.data(), all.node[i], all.ring[i], {a, b});
        }
  return all;
}

void CellContact::build() {
  bonds.clear();
  nears.clear();
  moved = 0.;
  most_shift = {0, 0};
  for (auto *lists : {&of_points, &of_rings})
    for (auto &list : *lists) list.clear();

  // Bonds in bins by their middles; a point looks as far as its reach and half the longest bond.
  const Bonds all = bonds_and_images();
  if (all.node.empty()) return;
  const double *const at[2] = {all.middle[0].data(), all.middle[1].data()};
  const Bins<2> bins(at, std::uint32_t(all.node.size()), 0.5 * all.reach * (1. + 1e-9), all.lo, all.hi);

  std::vector<std::uint32_t> found;
  for (std::size_t c = 0; c < groups.size(); ++c)
    for (std::uint32_t i = groups[c].begin; i < points_end(c); ++i) {
      const double p[2] = {origin[0][i], origin[1][i]};
      if (!(std::abs(p[0]) + std::abs(p[1]) < 1e300)) continue;
      const bool fluid = i >= groups[c].fluid;
      found.clear();
      bins.near(p, [&](const std::uint32_t b) {
        const std::uint32_t k = all.node[b], next = wall_node_after(groups[all.ring[b]], k);
        if (all.ring[b] == c && all.shift[b] == std::array<int, 2>{} && (fluid || k == i || next == i))
          return;  // fluid and its own wall are the fluid's matter
        const Vector<2> away = box.image(all.shift[b]);
        const double ex = origin[0][next] - origin[0][k], ey = origin[1][next] - origin[1][k];
        const double qx = p[0] - away[0] - origin[0][k], qy = p[1] - away[1] - origin[1][k],
                     l2 = ex * ex + ey * ey;
        const double t = l2 > 0. ? std::clamp((qx * ex + qy * ey) / l2, 0., 1.) : 0.;
        const double rx = qx - t * ex, ry = qy - t * ey;
        if (rx * rx + ry * ry < all.range * all.range) found.push_back(b);
      });
      std::sort(found.begin(), found.end());
      for (std::size_t k = 0; k < found.size();) {
        const std::uint32_t r = all.ring[found[k]], first = std::uint32_t(bonds.size());
        const std::array<int, 2> shift = all.shift[found[k]];
        for (; k < found.size() && all.ring[found[k]] == r && all.shift[found[k]] == shift; ++k)
          bonds.push_back(all.node[found[k]]);
        of_points[c].push_back(std::uint32_t(nears.size()));
        of_rings[r].push_back(std::uint32_t(nears.size()));
        nears.push_back({i, r, first, std::uint32_t(bonds.size()), fluid, shift, 0.});
        Hit hit;
        nears.back().slack =
            distance(nears.back(), hit) - (fluid ? parameters.fluid_range : parameters.range);
        for (int d = 0; d < 2; ++d) most_shift[d] = std::max(most_shift[d], std::abs(shift[d]));
      }
    }
}
}  // namespace turgor
