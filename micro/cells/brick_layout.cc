#include "micro/cells/brick_layout.h"

#include "micro/cells/brick_tissue.h"
#include "micro/cells/ring_geometry.h"
#include "micro/laws/counter_random.h"
#include "micro/laws/wall_bending.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace turgor {
namespace {
using Corner = std::tuple<int, int, int>;  // 0: lower end of wall i of row j, 1: its upper end, 2, 3: middle
                                           // of an outer side; j, i

struct Geometry {
  double L, jitter;
  std::uint64_t seed;

  Vector<2> at(const Corner &corner) const {
    const auto [kind, row, i] = corner;
    if (kind > 1)  // the middle between the two corners of cell i of that row
      return 0.5 * (at({kind - 2, row, i}) + at({kind - 2, row, i + 1}));
    const std::uint64_t counter =
        2 * ((std::uint64_t(row) * 1000003u + std::uint64_t(i)) * 2 + std::uint64_t(kind));
    const auto random = [&](const std::uint64_t k) {
      return jitter * L * (2. * random_uniform(seed, counter + k) - 1.);
    };
    return {(i + 0.5 * (row % 2)) * L + random(0), (row + kind) * L + random(1)};
  }

  /// The six corners of cell (i, row), counter-clockwise from the lower left one.
  std::array<Corner, 6> corners(const int i, const int row, const int rows) const {
    const int other = row % 2 ? i + 1 : i;  // wall of the neighbouring rows that meets this cell
    return {Corner{0, row, i},
            row > 0 ? Corner{1, row - 1, other} : Corner{2, row, i},
            Corner{0, row, i + 1},
            Corner{1, row, i + 1},
            row + 1 < rows ? Corner{0, row + 1, other} : Corner{3, row, i},
            Corner{1, row, i}};
  }
};

/// Which walls lie opposite each other, and which cells meet at a corner.
struct Neighbours {
  struct Wall {
    std::size_t cell;
    std::uint32_t on;  ///< side of the hexagon
  };
  std::map<std::pair<Corner, Corner>, Wall> walls;
  std::map<Corner, std::vector<std::pair<std::size_t, std::uint32_t>>> met;  ///< cells and their nodes
};

/// Bonds on the six sides of a ring of 4 n nodes, and the first node of each.
struct Sides {
  std::array<std::uint32_t, 6> bonds, first;
  explicit Sides(const std::uint32_t n)
      : bonds{n / 2, n / 2, n, n / 2, n / 2, n}, first{0, n / 2, n, 2 * n, 2 * n + n / 2, 3 * n} {}
};

/// The ring of cell c, and its neighbours.
void lay_ring(BrickLayout &layout, const std::size_t c, const std::array<Corner, 6> &corner,
              const Geometry &geometry, const Sides &sides, Neighbours &neighbours) {
  layout.rings.push_back({std::uint32_t(layout.nodes.size()), sides.first[5] + sides.bonds[5]});
  for (std::uint32_t s = 0; s < 6; ++s) {
    const Vector<2> from = geometry.at(corner[s]), to = geometry.at(corner[(s + 1) % 6]);
    for (std::uint32_t k = 0; k < sides.bonds[s]; ++k)
      layout.nodes.push_back(from + (to - from) * (double(k) / sides.bonds[s]));
    neighbours.walls[{corner[s], corner[(s + 1) % 6]}] = {c, s};
    neighbours.met[corner[s]].emplace_back(c, sides.first[s]);
  }
  const WallRing &ring = layout.rings.back();
  for (std::size_t i = ring.first; i < ring.end(); ++i) {
    const Vector<2> before = layout.nodes[i] - layout.nodes[ring.before(i)],
                    after = layout.nodes[ring.after(i)] - layout.nodes[i];
    layout.rest_length.push_back(after.norm());
    layout.rest_angle.push_back(WallBending::angle(before, after));
  }
}

/// Ties of all facing walls, not within the gap from a wall's end.
void tie(BrickLayout &layout, const Neighbours &neighbours, const Sides &sides, const double gap) {
  const double eps = 1e-6 * layout.spacing,
               stiffness = layout.parameters.lamella_ratio * layout.spring_stiffness;
  for (const auto &[ends, wall] : neighbours.walls) {
    const auto facing = neighbours.walls.find({ends.second, ends.first});
    if (facing == neighbours.walls.end() || facing->second.cell < wall.cell) continue;
    const WallRing &own = layout.rings[wall.cell], &other = layout.rings[facing->second.cell];
    const std::uint32_t count = sides.bonds[wall.on];
    for (std::uint32_t k = 0; k <= count; ++k)
      if (std::min(k, count - k) * layout.spacing >= gap - eps) {
        layout.ties.push_back({own.first + (sides.first[wall.on] + k) % own.count,
                               other.first + (sides.first[facing->second.on] + count - k) % other.count,
                               {{0, 0}},
                               stiffness});
        layout.tie_from_end.push_back(std::min(k, count - k));
      }
  }
}
}  // namespace

BrickLayout lay_bricks(const ParenchymaParameters &p, const BrickParameters &brick) {
  p.check();
  BrickLayout layout;
  layout.parameters = p;
  layout.parameters.wall_yield = brick.wall_law(p).yielding();
  layout.periodic = {false, false};
  layout.lattice << brick.columns * p.period, 0., 0., brick.rows * p.period;
  layout.spacing = p.period / p.nodes_per_side;
  layout.spring_stiffness = p.wall_law().derivative(1.) / layout.spacing;

  const Geometry geometry{p.period, brick.jitter, brick.seed};
  const Sides sides(p.nodes_per_side);
  Neighbours neighbours;
  for (std::size_t c = 0; c < std::size_t(brick.columns) * brick.rows; ++c) {
    const int row = int(c / brick.columns);
    lay_ring(layout, c, geometry.corners(int(c % brick.columns), row, int(brick.rows)), geometry, sides,
             neighbours);
  }
  layout.junctions.resize(layout.cells());
  for (const auto &[corner, places] : neighbours.met)
    if (places.size() > 2)
      for (const auto &[c, node] : places) layout.junctions[c].push_back(node);
  tie(layout, neighbours, sides, brick.gap);

  layout.node_mass.assign(layout.nodes.size(), p.wall_density * p.wall_thickness * p.depth * layout.spacing);
  layout.hinge.assign(layout.nodes.size(), p.bending_stiffness() / layout.spacing);
  const std::vector<double> x = layout.positions();
  for (const WallRing &ring : layout.rings)
    layout.fluid_mass.push_back(p.fluid_density * polygon_area(x, ring) * p.depth);
  layout.check();
  return layout;
}
}  // namespace turgor
