#include "micro/cells/tissue_strip.h"

#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
/// Without what lies across periods that end: ties, and air spaces, which then are open.
void cut_ends(CellLayout &layout, const std::array<bool, 2> &periodic) {
  layout.periodic = periodic;
  const auto across = [&](const std::array<int, 2> &from, const std::array<int, 2> &to) {
    return (!periodic[0] && from[0] != to[0]) || (!periodic[1] && from[1] != to[1]);
  };
  std::erase_if(layout.ties, [&](const LamellaTie &tie) { return across(tie.shift, {{0, 0}}); });
  std::erase_if(layout.air, [&](const AirSpace &space) {
    return std::any_of(space.begin(), space.end(),
                       [&](const AirFace &face) { return across(face.shift, space[0].shift); });
  });
}

/// Per cell its nodes (in the ring) at the corners of walls around air: as far as the gap, as laid, from
/// either end of a face.
std::vector<std::vector<std::uint32_t>> corners_at_air(const CellLayout &layout, const double gap) {
  std::vector<std::vector<std::uint32_t>> all(layout.cells());
  for (const AirSpace &space : layout.air)
    for (const AirFace &face : space) {
      const WallRing &ring = layout.rings[face.ring];
      std::vector<std::size_t> nodes{face.first};
      std::vector<double> along{0.};
      for (std::uint32_t k = 0; k < face.bonds; ++k) {
        along.push_back(along.back() + layout.rest_length[nodes.back()]);
        nodes.push_back(ring.after(nodes.back()));
      }
      for (const double at : {gap, along.back() - gap}) {
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < along.size(); ++k)
          if (std::abs(along[k] - at) < std::abs(along[nearest] - at)) nearest = k;
        const std::uint32_t corner = std::uint32_t(nodes[nearest] - ring.first);
        std::vector<std::uint32_t> &found = all[face.ring];
        if (std::find(found.begin(), found.end(), corner) == found.end()) found.push_back(corner);
      }
    }
  return all;
}

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

void check_strip(const TissueStructure &structure, const ParenchymaParameters &cell, const unsigned int rows,
                 const StripEnds ends) {
  structure.check();
  if (structure.kind == StructureKind::voronoi || structure.measured())
    throw std::invalid_argument(
        "Structure/Structure is " + word_of(structure.kind) +
        ", but a strip of particles (Sides) has cells that stand in rows: use square, hexagon "
        "or brick.");
  if (ends == StripEnds::all && rows % 2 != 0 && structure.kind != StructureKind::square)
    throw std::invalid_argument(
        "Rows is " + number_text(rows) + ", but rows of Structure/Structure = " + word_of(structure.kind) +
        " are moved by half a cell, so that a block (Sides = cut) has an even number of them: use " +
        number_text(rows + 1) + ".");
  if (structure.rotation != 0.)
    throw std::invalid_argument(
        "Structure/Rotation is " + number_text(structure.rotation) +
        " degrees, but a strip (Sides) is periodic along x, and so is its tissue: use 0.");
  laid_tissue(structure, cell, 2, 2);
}

BrickLayout lay_strip(const TissueStructure &structure, const ParenchymaParameters &cell,
                      const unsigned int columns, const unsigned int rows, const StripEnds ends) {
  check_strip(structure, cell, rows, ends);
  const bool block = ends == StripEnds::all;
  BrickLayout strip;
  static_cast<CellLayout &>(strip) =
      turgid_tissue(structure, cell, columns, rows, block ? Periods::upright : Periods::leaning);
  cut_ends(strip, {!block, false});
  strip.junctions = structure.gap > 0. ? corners_at_air(strip, structure.gap) : junctions_of(strip);
  strip.tie_from_end = from_ends(strip);
  return strip;
}
}  // namespace turgor
