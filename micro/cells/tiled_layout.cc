#include "micro/cells/tiled_layout.h"

#include "micro/cells/air_spaces.h"
#include "micro/laws/wall_bending.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace turgor {
namespace {
/// A side cut into bonds: distances (m) of its nodes from where it begins, its end included, and which of
/// them are tied.
struct CutSide {
  std::vector<double> at;
  std::size_t first_tied = 0, last_tied = 0;  // one after the last

  std::size_t bonds() const { return at.size() - 1; }
  /// m, of the wall that a tie at node k stands for
  double share(const std::size_t k) const {
    return k == 0 ? at[1] : k == bonds() ? at[k] - at[k - 1] : 0.5 * (at[k + 1] - at[k - 1]);
  }
};

void cut(std::vector<double> &at, const double to, const double spacing, const int least) {
  const double from = at.back();
  const int n = std::max(least, int(std::floor((to - from) / spacing + 0.5 +
                                               1e-6)));  // halves go up whatever round-off does to them
  for (int k = 1; k < n; ++k) at.push_back(from + (to - from) * k / n);
  at.push_back(to);
}

CutSide cut_side(const double length, const double spacing, const double gap_before, const double gap_after) {
  CutSide side{{0.}};
  if (gap_before + gap_after >= length) {
    cut(side.at, length, spacing, 2);
    return side;
  }
  if (gap_before > 0.) cut(side.at, gap_before, spacing, 1);
  side.first_tied = side.bonds();
  cut(side.at, length - gap_after, spacing, gap_before > 0. || gap_after > 0. ? 1 : 2);
  side.last_tied = side.bonds() + 1;
  if (gap_after > 0.) cut(side.at, length, spacing, 1);
  return side;
}

/// The same wall from its other side.
CutSide seen_from_behind(const CutSide &front) {
  CutSide back;
  for (auto at = front.at.rbegin(); at != front.at.rend(); ++at) back.at.push_back(front.at.back() - *at);
  back.first_tied = front.bonds() + 1 - front.last_tied;
  back.last_tied = front.bonds() + 1 - front.first_tied;
  return back;
}

/// How many cells have a corner there.
std::vector<unsigned int> cells_that_meet(const Tiling &tiling) {
  std::vector<unsigned int> count(tiling.vertices.size(), 0);
  for (const auto &cell : tiling.cells)
    for (const TilingCorner &corner : cell) ++count[corner.vertex];
  return count;
}

void set_walls(CellLayout &layout, const double stretch) {
  const ParenchymaParameters &p = layout.parameters;
  for (const WallRing &ring : layout.rings)
    for (std::size_t i = ring.first; i < ring.end(); ++i) {
      const Vector<2> before = layout.nodes[i] - layout.nodes[ring.before(i)],
                      after = layout.nodes[ring.after(i)] - layout.nodes[i];
      const double share = 0.5 * (before.norm() + after.norm());
      layout.rest_length.push_back(after.norm() / stretch);
      layout.rest_angle.push_back(WallBending::angle(before, after));
      layout.hinge.push_back(p.bending_stiffness() / share);
      layout.node_mass.push_back(p.wall_density * p.wall_thickness * p.depth * share);
    }
}
}  // namespace

CellLayout lay_cells(const Tiling &tiling, const ParenchymaParameters &p, const double gap,
                     const double stretch) {
  p.check();
  tiling.check();
  if (!(gap >= 0.) || !(stretch > 0.))
    throw std::invalid_argument("Walls need a gap of zero or more (m) and a positive stretch.");
  CellLayout layout;
  layout.parameters = p;
  layout.lattice = tiling.lattice;
  layout.periodic = {tiling.periodic, tiling.periodic};
  layout.spacing = p.period / p.nodes_per_side;
  layout.spring_stiffness = p.wall_law().derivative(1.) / (layout.spacing / stretch);

  const std::vector<unsigned int> meet = cells_that_meet(tiling);
  const auto facing = tiling.facing();
  std::vector<std::vector<CutSide>> sides(tiling.cells.size());
  std::vector<std::vector<std::uint32_t>> first(tiling.cells.size());  // node at which a side begins
  for (std::size_t c = 0; c < tiling.cells.size(); ++c) {
    const auto &corners = tiling.cells[c];
    const std::uint32_t begin = std::uint32_t(layout.nodes.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const TilingCorner &from = corners[k], &to = corners[(k + 1) % corners.size()];
      const auto gap_at = [&](const TilingCorner &corner) {
        return facing[c][k].exists() && meet[corner.vertex] > 2 ? gap : 0.;
      };
      const double length = tiling.side_length(c, k);
      const FacingSide &other = facing[c][k];
      const bool cut_already = other.exists() && (other.cell < c || (other.cell == c && other.side < k));
      sides[c].push_back(cut_already ? seen_from_behind(sides[other.cell][other.side])
                                     : cut_side(length, layout.spacing, gap_at(from), gap_at(to)));
      first[c].push_back(std::uint32_t(layout.nodes.size()));
      for (std::size_t i = 0; i < sides[c][k].bonds(); ++i)
        layout.nodes.push_back(tiling.place(from) +
                               sides[c][k].at[i] / length * (tiling.place(to) - tiling.place(from)));
    }
    layout.rings.push_back({begin, std::uint32_t(layout.nodes.size()) - begin});
    layout.fluid_mass.push_back(p.equation_of_state().density_at(p.turgor) * tiling.area(c) * p.depth);
  }
  set_walls(layout, stretch);

  const auto node = [&](const std::size_t c, const std::size_t k, const std::size_t i) {
    const WallRing &ring = layout.rings[c];
    const std::size_t n = first[c][k] + i;
    return std::uint32_t(n == ring.end() ? ring.first : n);
  };
  for (std::size_t c = 0; c < tiling.cells.size(); ++c)
    for (std::size_t k = 0; k < tiling.cells[c].size(); ++k) {
      const FacingSide &other = facing[c][k];
      if (!other.exists() || other.cell < c || (other.cell == c && other.side < k))
        continue;  // each tie once
      const CutSide &side = sides[c][k];
      for (std::size_t i = side.first_tied; i < side.last_tied; ++i)
        layout.ties.push_back({node(c, k, i), node(other.cell, other.side, side.bonds() - i), other.shift,
                               p.lamella_ratio * layout.spring_stiffness * side.share(i) / layout.spacing});
    }
  if (gap > 0. && tiling.periodic) layout.air = find_air_spaces(layout);
  layout.check();
  return layout;
}
}  // namespace turgor
