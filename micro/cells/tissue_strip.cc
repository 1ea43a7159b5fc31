#include "micro/cells/tissue_strip.h"

#include "run/number_text.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
/// Per cell its nodes (in the ring) that are tied to two other cells or more: where three meet.
std::vector<std::vector<std::uint32_t>> junctions_of(const CellLayout &layout) {
  std::vector<unsigned int> ties(layout.nodes.size(), 0);
  for (const LamellaTie &tie : layout.ties)
    for (const std::uint32_t node : {tie.a, tie.b}) ++ties[node];
  std::vector<std::vector<std::uint32_t>> all;
  for (const WallRing &ring : layout.rings) {
    all.emplace_back();
    for (std::uint32_t k = 0; k < ring.count; ++k)
      if (ties[ring.first + k] > 1) all.back().push_back(k);
  }
  return all;
}

/// Bonds along the ring of a tie's first node to the nearest junction; the whole ring where it has none.
std::vector<std::uint32_t> from_ends(const BrickLayout &layout) {
  std::vector<std::uint32_t> cell_of;
  for (std::size_t c = 0; c < layout.cells(); ++c)
    cell_of.insert(cell_of.end(), layout.rings[c].count, std::uint32_t(c));
  std::vector<std::uint32_t> all;
  for (const LamellaTie &tie : layout.ties) {
    const std::uint32_t c = cell_of[tie.a];
    const WallRing &ring = layout.rings[c];
    std::uint32_t least = ring.count;
    for (const std::uint32_t junction : layout.junctions[c]) {
      const std::uint32_t d = (tie.a - ring.first + ring.count - junction) % ring.count;
      least = std::min({least, d, ring.count - d});
    }
    all.push_back(least);
  }
  return all;
}
}  // namespace

void check_strip(const TissueStructure &structure, const ParenchymaParameters &cell) {
  structure.check();
  if (structure.kind == StructureKind::voronoi || structure.measured())
    throw std::invalid_argument("Structure/Structure is " + word_of(structure.kind) +
                                ", but a strip of particles (Sides) has cells with equally many wall nodes: "
                                "use square, hexagon or brick.");
  if (structure.gap > 0.)
    throw std::invalid_argument("Structure/Gap is " + number_text(structure.gap) +
                                " m, but a strip of particles (Sides) is dense: use 0.");
  if (structure.rotation != 0.)
    throw std::invalid_argument(
        "Structure/Rotation is " + number_text(structure.rotation) +
        " degrees, but a strip (Sides) is periodic along x, and so is its tissue: use 0.");
  const CellLayout few = laid_tissue(structure, cell, 2, 2);
  for (const WallRing &ring : few.rings)
    if (ring.count != few.rings[0].count)
      throw std::invalid_argument(
          "Structure/Corner jitter is " + number_text(structure.jitter) +
          ", with which cells have unlike numbers of wall nodes; a strip of particles (Sides) needs equal "
          "ones: use a smaller jitter, or 0.");
}

BrickLayout lay_strip(const TissueStructure &structure, const ParenchymaParameters &cell,
                      const unsigned int columns, const unsigned int rows) {
  check_strip(structure, cell);
  BrickLayout strip;
  static_cast<CellLayout &>(strip) = turgid_tissue(structure, cell, columns, rows);
  strip.periodic = {true, false};
  std::erase_if(strip.ties, [](const LamellaTie &tie) { return tie.shift[1] != 0; });
  for (const WallRing &ring : strip.rings)
    if (ring.count != strip.rings[0].count)
      throw std::invalid_argument(
          "The cells of this strip have unlike numbers of wall nodes: use a smaller Structure/Corner jitter, "
          "or 0.");
  strip.junctions = junctions_of(strip);
  strip.tie_from_end = from_ends(strip);
  return strip;
}
}  // namespace turgor
