#include "micro/cells/structured_block.h"

#include "micro/geometry/tiling.h"
#include "run/number_text.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
bool moved_rows(const TissueStructure &structure) {
  return structure.kind == StructureKind::hexagon || structure.kind == StructureKind::brick;
}
}  // namespace

void check_block(const TissueStructure &structure, const ParenchymaParameters &cell,
                 const unsigned int rows) {
  structure.check();
  require_walls_that_hold(structure, cell);
  if (structure.rotation != 0.)
    throw std::invalid_argument("Structure/Rotation is " + number_text(structure.rotation) +
                                " degrees, but the sides of a clamped block are upright, and so is its "
                                "tissue: use 0.");
  if (structure.gap > 0.)
    throw std::invalid_argument("Structure/Gap is " + number_text(structure.gap) +
                                " m, but the tissue of a clamped block is dense: use 0.");
  if (moved_rows(structure) && rows % 2 != 0)
    throw std::invalid_argument(
        "Rows is " + number_text(rows) + ", but rows of Structure/Structure = " + word_of(structure.kind) +
        " are moved by half a cell, so that a block has an even number of them: use " +
        number_text(rows + 1) + ".");
}

CellLayout turgid_block(const TissueStructure &structure, const ParenchymaParameters &cell,
                        const unsigned int columns, const unsigned int rows) {
  check_block(structure, cell, rows);
  const bool regular = moved_rows(structure) && structure.jitter == 0.;
  return regular ? repeated(turgid_tissue(structure, cell, 1, 2, Periods::upright), columns, rows / 2)
                 : turgid_tissue(structure, cell, columns, rows, Periods::upright);
}

CellLayout repeated(const CellLayout &one, const unsigned int columns, const unsigned int rows) {
  const auto floored = [](const int a, const int n) {
    const int times = a >= 0 ? a / n : -((n - 1 - a) / n);
    return std::pair(times, a - times * n);
  };
  CellLayout all = one;
  all.lattice.col(0) *= columns;
  all.lattice.col(1) *= rows;
  for (auto *values : {&all.rest_length, &all.rest_angle, &all.hinge, &all.node_mass, &all.fluid_mass})
    values->clear();
  all.nodes.clear();
  all.rings.clear();
  all.ties.clear();
  const std::size_t copies = std::size_t(columns) * rows;
  // where node k of the copy (i, j) lies
  std::vector<std::uint32_t> place(one.nodes.size() * copies);
  for (unsigned int j = 0; j < rows; ++j)
    for (std::size_t c = 0; c < one.cells(); ++c)
      for (unsigned int i = 0; i < columns; ++i) {
        const WallRing &ring = one.rings[c];
        all.rings.push_back({std::uint32_t(all.nodes.size()), ring.count});
        all.fluid_mass.push_back(one.fluid_mass[c]);
        for (std::size_t k = ring.first; k < ring.end(); ++k) {
          place[(std::size_t(j) * columns + i) * one.nodes.size() + k] = std::uint32_t(all.nodes.size());
          all.nodes.push_back(one.nodes[k] + one.lattice * Vector<2>(i, j));
          all.rest_length.push_back(one.rest_length[k]);
          all.rest_angle.push_back(one.rest_angle[k]);
          all.hinge.push_back(one.hinge[k]);
          all.node_mass.push_back(one.node_mass[k]);
        }
      }
  for (unsigned int j = 0; j < rows; ++j)
    for (unsigned int i = 0; i < columns; ++i)
      for (LamellaTie tie : one.ties) {
        const auto [across, column] = floored(int(i) + tie.shift[0], int(columns));
        const auto [up, row] = floored(int(j) + tie.shift[1], int(rows));
        tie.a = place[(std::size_t(j) * columns + i) * one.nodes.size() + tie.a];
        tie.b = place[(std::size_t(row) * columns + std::size_t(column)) * one.nodes.size() + tie.b];
        tie.shift = {{across, up}};
        all.ties.push_back(tie);
      }
  return all;
}

bool all_alike(const CellLayout &layout) {
  const WallRing &first = layout.rings[0];
  const double near = 1e-6 * layout.spacing;
  for (std::size_t c = 1; c < layout.cells(); ++c) {
    const WallRing &ring = layout.rings[c];
    if (ring.count != first.count ||
        std::abs(layout.fluid_mass[c] - layout.fluid_mass[0]) > 1e-6 * layout.fluid_mass[0])
      return false;
    const Vector<2> away = layout.nodes[ring.first] - layout.nodes[first.first];
    for (std::uint32_t k = 0; k < ring.count; ++k)
      if ((layout.nodes[ring.first + k] - layout.nodes[first.first + k] - away).norm() > near ||
          std::abs(layout.rest_length[ring.first + k] - layout.rest_length[first.first + k]) > near)
        return false;
  }
  return true;
}

Vector<2> place_in_block(const TissueStructure &structure, const CellLayout &layout,
                         const unsigned int columns, const std::size_t cell) {
  if (structure.kind != StructureKind::voronoi && !structure.measured())
    return {double(cell % columns), double(cell / columns)};
  const WallRing &ring = layout.rings[cell];
  std::vector<Vector<2>> outline(layout.nodes.begin() + ring.first,
                                 layout.nodes.begin() + std::ptrdiff_t(ring.end()));
  return polygon_centroid(outline) / (layout.lattice.col(0).norm() / columns);
}
}  // namespace turgor
