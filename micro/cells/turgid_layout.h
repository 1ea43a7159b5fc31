// The turgid reference of cells whose fluid is at rest (hydrostatic_network.h): node positions in equilibrium at the layout's own lattice,
// and fluid masses, all changed by one factor, with which the mean of the virial stress there is zero (to 1e-10 of turgor or what round-off of
// the masses allows), by secant steps. What is left is the deviator, 0 by symmetry where the lattice is that of square cells. annealed_cells.h has
// the reference of cells filled with particles.
//
//   const HydrostaticNetwork network(turgid_parenchyma(parameters, 2, 2, true, true));
#pragma once

#include "micro/cells/cell_layout.h"

namespace turgor
{
/// Throws std::invalid_argument where no mass balances the walls. The layout is periodic both ways.
CellLayout turgid(CellLayout layout);

/// A grid of square cells, every one the same cell of the periodic grid, brought to turgor.
CellLayout turgid_parenchyma(const ParenchymaParameters &parameters, unsigned int columns, unsigned int rows, bool periodic_x,
                             bool periodic_y);
} // namespace turgor
