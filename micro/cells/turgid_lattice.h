// The turgid reference of any periodic layout, its lattice included: cells of stress-free walls filled until the fluid has its turgor, with
// the tissue free to widen, to lengthen and to shear until it carries no stress at all.
//
//   turgor in five steps, held in every cell (E = -p V); at each, Newton's method for F = [[a, b], [0, d]] on the relaxed energy
//   min over x of E(x, F H), with the exact tangent of NetworkEquilibrium::relaxed_curvature; the first period keeps its direction (the axes of F
//   are those of the first period, so that a layout that is turned is answered turned). Then every cell keeps the water it has: m = rho(p) V.
//
// Contact of walls across air spaces is left out: turgor opens them.
//
//   const HydrostaticNetwork network(turgid_with_lattice(lay_cells(tiling, parameters)));
//
// In: a layout of walls without stress, periodic both ways. Out: the layout with its nodes, lattice and fluid masses at turgor; mean stress below
// 1e-9 of turgor. Throws std::invalid_argument with a sentence where there is no such state.
#pragma once

#include "micro/cells/cell_layout.h"

namespace turgor
{
struct TurgidSearch
{
  int lattice_steps = 0; ///< Newton steps of the lattice
  int iterations = 0;    ///< Newton iterations of the nodes
  double stress = 0.;    ///< Pa, largest component of the mean stress that is left
};

CellLayout turgid_with_lattice(CellLayout layout, TurgidSearch *how = nullptr);
} // namespace turgor
