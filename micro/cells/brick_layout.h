// Where the cells of an aggregate of bricks lie before it is inflated (thesis 3.3.2): rows of rectangles,
// every second row moved by half a cell, corners moved at random a little.
//
// Every cell is a hexagon from the start: its four corners, and the corners of the row below and above in the
// middle of its lower and upper side. Facing walls carry nodes at the same places and are tied one to one;
// dense: all along; sparse: not within Gap of a wall's end. Rings run counter-clockwise from the lower left
// corner, 4 n nodes: h, h, n, h, h, n bonds on the hexagon's sides with h = n/2. Walls are free of stress as
// they are laid, the fluid is free of pressure; nodes, hinges and ties are all of the same strength, whatever
// the jitter does to their lengths.
#pragma once

#include "micro/cells/cell_layout.h"

namespace turgor {
struct BrickParameters;

struct BrickLayout : CellLayout {
  std::vector<std::uint32_t>
      tie_from_end;  ///< per tie: bonds between it and the nearer end of the wall that two cells share
  std::vector<std::vector<std::uint32_t>>
      junctions;  ///< per cell: its nodes (in the ring) where three cells meet
};

BrickLayout lay_bricks(const ParenchymaParameters &cell, const BrickParameters &brick);
}  // namespace turgor
