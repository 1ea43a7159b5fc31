// A block cut out of periodic tissue, clamped at its left side: cells of any layout (cell_layout.h).
//
//   cut      ties of the periodic tissue that leave the block: across both periods, or across the first alone
//            where the block is a slab
//   clamped  nodes at which cut ties meet the block from the left
//   right    nodes from which cut ties leave to the right, and the height of the side that each carries
//   probe    nodes nearest the middle of those from which they leave to the right; two where two cells meet
//            there
//
// What the missing neighbours pull in the reference can stay as dead forces: then the block begins in
// equilibrium and its surface behaves as the interior does (what FE^2 assumes).
//
//   const CutBlock block = cut_out(layout, layout, Surfaces::frozen);
//   for (const CutBlock::Pull &pull : block.pulls([&](std::uint32_t node) { return block.layout.nodes[node];
//     })) ...
//
// In and out: m, N.
#pragma once

#include "micro/cells/cell_layout.h"

#include <functional>
#include <string>

namespace turgor {
/// What becomes of the surfaces of a block of cells.
enum class Surfaces {
  frozen,   ///< the forces that the missing neighbours exert in the reference stay as dead forces
  free,     ///< nothing outside: turgid surface cells bulge; the block is relaxed before t = 0, at fixed mass
  osmosis,  ///< as free, but water flows until every cell has its turgor again
  slab      ///< periodic in y, frozen at the right side
};
constexpr const char *words_of(Surfaces) { return "frozen|free|osmosis|slab"; }

struct CutBlock {
  struct Pull {
    std::uint32_t node;
    Vector<2> force;  ///< N
  };

  /// A node of the right side and its share of the side's height: half of the way to the nodes above and
  /// below, those at the ends to the end of the block. All shares together are the height.
  struct SideNode {
    std::uint32_t node;
    double height;  ///< m
  };

  CellLayout layout;                          ///< without the ties that are cut
  std::vector<LamellaTie> cut;                ///< with their shifts
  std::vector<std::uint32_t> clamped, probe;  ///< nodes, each once
  std::vector<SideNode> right;                ///< upwards
  double width = 0.;                          ///< m, along the first period
  double density = 0.;                        ///< kg/m^3, fluid and walls over the lattice

  /// What cut ties pull with nodes at these places: none where surfaces are free.
  std::vector<Pull> pulls(const std::function<Vector<2>(std::uint32_t)> &place) const;
  /// What a traction (Pa, per reference area) on the right side is to its nodes.
  std::vector<Pull> carrying(const Vector<2> &traction) const;

  Surfaces surfaces = Surfaces::frozen;
};

/// laid: the tissue as it is laid, which tells where its sides are; reference: the same at F = I. Both are
/// periodic both ways, with the same rings and ties. Throws std::invalid_argument where they are not, or no
/// tie leaves to the right.
CutBlock cut_out(const CellLayout &laid, const CellLayout &reference, Surfaces surfaces);
}  // namespace turgor
