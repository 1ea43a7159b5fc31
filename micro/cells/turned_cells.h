// Cells turned as they are: walls, lattice and what fills them by one angle.
//
// A tissue that is turned has to answer as before in its own frame. Fluid that were laid anew in turned walls
// would lie otherwise beside them (rows along the laboratory's axes, no longer along the walls), and answer
// 0.2 % otherwise in shear: no property of the tissue. So fluid is laid and annealed upright and turned with
// its walls.
//
//   layout = turned(std::move(layout), 30. * std::numbers::pi / 180.);
#pragma once

#include "micro/cells/sph_parenchyma.h"

namespace turgor {
/// The layout turned by an angle (rad, counter-clockwise) about the origin, its lattice too.
CellLayout turned(CellLayout layout, double angle);

/// The contents of cells of that layout (m, about each cell's first node), turned with it.
std::vector<CellContents> turned(std::vector<CellContents> cells, double angle);
}  // namespace turgor
