#include "micro/cells/parenchyma.h"

#include "run/number_text.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace turgor {
namespace {
/// Node of the ring of 4 n nodes, as its place on the grid of nodes of the cell: (0, 0) to (n, n).
std::array<std::uint32_t, 2> place_in_square(const std::uint32_t n, const std::uint32_t node) {
  const std::uint32_t side = node / n, k = node % n;
  return side == 0   ? std::array{k, 0u}
         : side == 1 ? std::array{n, k}
         : side == 2 ? std::array{n - k, n}
                     : std::array{0u, n - k};
}

void tie_facing_walls(CellLayout &layout, const unsigned int columns, const unsigned int rows,
                      const double stiffness) {
  const std::uint32_t ring = layout.rings.front().count, n = ring / 4;
  for (unsigned int j = 0; j < rows; ++j)
    for (unsigned int i = 0; i < columns; ++i) {
      const std::uint32_t here = layout.rings[j * columns + i].first;
      const bool last_column = i + 1 == columns, last_row = j + 1 == rows;
      if (!last_column || layout.periodic[0]) {
        const std::uint32_t right = layout.rings[j * columns + (last_column ? 0 : i + 1)].first;
        for (std::uint32_t k = 0; k <= n; ++k)
          layout.ties.push_back(
              {here + n + k, right + (ring - k) % ring, {{last_column ? 1 : 0, 0}}, stiffness});
      }
      if (!last_row || layout.periodic[1]) {
        const std::uint32_t above = layout.rings[(last_row ? 0 : j + 1) * columns + i].first;
        for (std::uint32_t k = 0; k <= n; ++k)
          layout.ties.push_back({here + 2 * n + k, above + n - k, {{0, last_row ? 1 : 0}}, stiffness});
      }
    }
}
}  // namespace

double turgid_wall_stretch(const ParenchymaParameters &p) {
  return p.wall_law().stretch_at(0.5 * p.turgor * p.period * p.depth);
}

CellLayout make_parenchyma(const ParenchymaParameters &p, const unsigned int columns, const unsigned int rows,
                           const bool periodic_x, const bool periodic_y) {
  p.check();
  if (columns < 1 || rows < 1)
    throw std::invalid_argument("Columns and Rows have to be at least 1 (they are " + number_text(columns) +
                                " and " + number_text(rows) + ").");
  const std::uint32_t n = p.nodes_per_side, ring = 4 * n;
  if (!(double(columns) * rows * ring < double(std::numeric_limits<std::uint32_t>::max())))
    throw std::invalid_argument(
        "Cell/Nodes per side is " + number_text(n) +
        ", but it has to be small enough for fewer than 2^32 wall nodes in the patch.");

  CellLayout layout;
  layout.parameters = p;
  layout.periodic = {periodic_x, periodic_y};
  layout.lattice << columns * p.period, 0., 0., rows * p.period;
  layout.spacing = p.period / n;
  for (unsigned int j = 0; j < rows; ++j)
    for (unsigned int i = 0; i < columns; ++i) {
      layout.rings.push_back({static_cast<std::uint32_t>(layout.nodes.size()), ring});
      for (std::uint32_t k = 0; k < ring; ++k) {
        // Grid lines from the integers, so that facing walls share their coordinates bit for bit.
        const auto [a, b] = place_in_square(n, k);
        layout.nodes.push_back({(double(i) * n + a) * layout.spacing, (double(j) * n + b) * layout.spacing});
        layout.rest_angle.push_back(k % n == 0 ? std::numbers::pi / 2. : 0.);
      }
    }
  const double rest_length = layout.spacing / turgid_wall_stretch(p);
  layout.rest_length.assign(layout.nodes.size(), rest_length);
  layout.hinge.assign(layout.nodes.size(), p.bending_stiffness() / layout.spacing);
  layout.node_mass.assign(layout.nodes.size(), p.wall_density * p.wall_thickness * p.depth * layout.spacing);
  layout.fluid_mass.assign(layout.rings.size(),
                           p.equation_of_state().density_at(p.turgor) * (p.period * p.period * p.depth));

  const double tie_stiffness = p.lamella_ratio * p.wall_law().derivative(1.) / rest_length;
  layout.spring_stiffness = tie_stiffness / p.lamella_ratio;
  tie_facing_walls(layout, columns, rows, tie_stiffness);
  return layout;
}
}  // namespace turgor
