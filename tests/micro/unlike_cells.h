// Five periodic cells that are not alike, for the tests of networks and RVEs: two rows of bricks of unequal
// lengths in an oblique lattice, so that cells are octagons, hexagons and a quadrilateral, corners moved at
// random; walls, hinges, ties, nodes and fluid of their own strengths and masses.
#pragma once

#include "micro/cells/cell_layout.h"
#include "micro/geometry/tiling.h"
#include "micro/laws/counter_random.h"
#include "micro/laws/wall_bending.h"

#include <algorithm>
#include <cmath>

namespace turgor::test {
inline Tiling unlike_polygons() {
  const double unit = 60e-6;
  Tiling tiling;
  tiling.lattice << 4. * unit, 0.3 * unit, 0., 2. * unit;
  std::uint64_t draw = 0;
  const auto random = [&] { return 0.1 * unit * (2. * random_uniform(5, draw++) - 1.); };
  for (const double y : {0., 1.})  // vertices 0 to 4, 5 to 9, from left to right
    for (const double x : {0., 1., 2., 2.5, 3.5}) {
      const double across = random(), up = random();
      tiling.vertices.push_back({x * unit + across, y * unit + up});
    }
  // the upper row stands on line 1 and carries line 0 of the next period
  tiling.cells = {{{0}, {1}, {2}, {3}, {8}, {7}, {6}, {5}},
                  {{3}, {4}, {0, {{1, 0}}}, {5, {{1, 0}}}, {9}, {8}},
                  {{6}, {7}, {2, {{0, 1}}}, {1, {{0, 1}}}},
                  {{7}, {8}, {9}, {4, {{0, 1}}}, {3, {{0, 1}}}, {2, {{0, 1}}}},
                  {{9}, {5, {{1, 0}}}, {6, {{1, 0}}}, {1, {{1, 1}}}, {0, {{1, 1}}}, {4, {{0, 1}}}}};
  return tiling;
}

/// Stretched by turgor in this shape, about in balance.
inline CellLayout unlike_cells(const double spacing = 20e-6) {
  const Tiling tiling = unlike_polygons();
  CellLayout layout;
  const ParenchymaParameters &p = layout.parameters;
  layout.lattice = tiling.lattice;
  layout.spacing = spacing;
  layout.spring_stiffness = p.wall_law().derivative(1.) / spacing;
  const auto bonds = [&](const std::size_t c, const std::size_t side) {
    return std::uint32_t(std::max(2., std::round(tiling.side_length(c, side) / spacing)));
  };
  std::vector<std::vector<std::uint32_t>> first(tiling.cells.size());  // node where a side begins
  for (std::size_t c = 0; c < tiling.cells.size(); ++c) {
    const std::uint32_t begin = std::uint32_t(layout.nodes.size());
    const std::vector<Vector<2>> corners = tiling.outline(c);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      first[c].push_back(std::uint32_t(layout.nodes.size()));
      for (std::uint32_t i = 0, n = bonds(c, k); i < n; ++i)
        layout.nodes.push_back(corners[k] +
                               (corners[(k + 1) % corners.size()] - corners[k]) * (double(i) / n));
    }
    layout.rings.push_back({begin, std::uint32_t(layout.nodes.size()) - begin});
    layout.fluid_mass.push_back(p.equation_of_state().density_at((0.9 + 0.05 * double(c)) * p.turgor) *
                                tiling.area(c) * p.depth);
  }
  for (const WallRing &ring : layout.rings)
    for (std::size_t i = ring.first; i < ring.end(); ++i) {
      const Vector<2> before = layout.nodes[i] - layout.nodes[ring.before(i)],
                      after = layout.nodes[ring.after(i)] - layout.nodes[i];
      layout.rest_length.push_back(after.norm() / (1.02 + 0.01 * random_uniform(6, i)));
      layout.rest_angle.push_back(WallBending::angle(before, after));
      layout.hinge.push_back(p.bending_stiffness() / spacing * (1. + random_uniform(7, i)));
      layout.node_mass.push_back(p.wall_density * p.wall_thickness * p.depth * spacing *
                                 (1. + random_uniform(8, i)));
    }
  const auto facing = tiling.facing();
  const auto node = [&](const std::size_t c, const std::size_t side, const std::uint32_t i) {
    const WallRing &ring = layout.rings[c];
    return first[c][side] + i == ring.end() ? ring.first : first[c][side] + i;
  };
  for (std::size_t c = 0; c < facing.size(); ++c)
    for (std::size_t side = 0; side < facing[c].size(); ++side)
      if (const FacingSide &other = facing[c][side]; other.cell > c || (other.cell == c && other.side > side))
        for (std::uint32_t i = 0, n = bonds(c, side); i <= n; ++i)
          layout.ties.push_back(
              {node(c, side, i), node(other.cell, other.side, n - i), other.shift,
               p.lamella_ratio * layout.spring_stiffness * (1. + random_uniform(9, layout.ties.size()))});
  return layout;
}
}  // namespace turgor::test
