// Cells whose fluid is at rest (hydrostatic_network.h) come to turgor: the reference F = I, as an equilibrium
// of the network. (Particles come to it by motion: annealed_cells.h, micro/processes/bring_to_turgor.h,
// tissue_inflation.h.) Two questions, one search for equilibrium (network_equilibrium.h):
//
//   turgid               the lattice is given. Fluid masses, all changed by one factor, with which the mean
//                        of the virial stress is zero (to 1e-10 of turgor or what round-off of the masses
//                        allows), by secant steps. What is left is the deviator, 0 by symmetry where the
//                        lattice is that of square cells.
//   turgid_with_lattice  cells of stress-free walls are filled until the fluid has its turgor, with the
//                        tissue free to widen, to lengthen and to shear until it carries no stress at all:
//                        turgor in five steps, held in every cell (E = -p V); at each, Newton's method for F
//                        = [[a, b], [0, d]] on the relaxed energy min over x of E(x, F H), with the exact
//                        tangent of NetworkEquilibrium::relaxed_curvature; the first period keeps its
//                        direction (the axes of F are those of the first period, so that a layout that is
//                        turned is answered turned). Then every cell keeps the water it has: m = rho(p) V.
//                        Walls touch across air spaces only when turgor has opened them: with contact from
//                        the beginning the corners, which are laid on each other, find a state of their own.
//                        Then the lattice gives way once more, with contact.
//
//   const HydrostaticNetwork network(turgid_parenchyma(parameters, 2, 2, true, true));
//   const HydrostaticNetwork other(turgid_with_lattice(lay_cells(tiling, parameters)));
//
// Layouts are periodic both ways. Throws std::invalid_argument with a sentence where there is no such state.
#pragma once

#include "micro/cells/cell_layout.h"

namespace turgor {
/// Throws std::invalid_argument where no mass balances the walls.
CellLayout turgid(CellLayout layout);

struct TurgidSearch {
  int lattice_steps = 0;  ///< Newton steps of the lattice
  int iterations = 0;     ///< Newton iterations of the nodes
  double stress = 0.;     ///< Pa, largest component of the mean stress that is left
};

/// In: walls without stress. Out: nodes, lattice and fluid masses at turgor; mean stress below 1e-9 of
/// turgor, or below what 1e-11 of strain makes of the walls (walls much stiffer than turgor).
CellLayout turgid_with_lattice(CellLayout layout, TurgidSearch *how = nullptr);

/// A grid of square cells, every one the same cell of the periodic grid, brought to turgor.
CellLayout turgid_parenchyma(const ParenchymaParameters &parameters, unsigned int columns, unsigned int rows,
                             bool periodic_x, bool periodic_y);
}  // namespace turgor
