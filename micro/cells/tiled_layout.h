// Walls laid along a tiling: every cell a ring of wall nodes, facing walls tied node by node, across the
// periods where the tiling has them.
//
//   bonds of a side   its length over the spacing, rounded, 2 at least; alike on both sides of a wall
//   gap               at either end of a shared wall where three cells or more meet this length stays untied,
//                     and a node lies at its end; a wall shorter than two gaps is not tied at all
//   ties              lamella ratio x stiffness of a wall spring, in proportion to the length of wall a node
//                     stands for (at an end of a wall that of the bond there): the lamella of a wall does not
//                     depend on how finely it is resolved there
//   rest state        bonds laid `stretch` times as long as they are without stress; hinges at the angles
//                     they are laid with
//
//   const CellLayout cells = lay_cells(replicated(brick_tiling(100e-6), 2, 2), parameters);
//     // flat and free of stress
//
// spacing = Cell/Period over Cell/Nodes per side; the fluid has the density of turgor. In and out: m. Throws
// std::invalid_argument.
#pragma once

#include "micro/cells/cell_layout.h"
#include "micro/geometry/tiling.h"

namespace turgor {
CellLayout lay_cells(const Tiling &tiling, const ParenchymaParameters &parameters, double gap = 0.,
                     double stretch = 1.);
}  // namespace turgor
