// A parenchyma cell (thesis 3.2): its wall and fluid, its size and how finely it is resolved: the entries of
// the subsection Cell.
//
// A 2D scene is a slab of depth z0: masses, forces and energies are those of the slab. SI units.
#pragma once

#include "micro/cells/fluid_parameters.h"
#include "micro/cells/wall_parameters.h"

namespace turgor {
struct ParenchymaParameters : WallParameters, FluidParameters {
  double period = 100e-6;            ///< m, inflated cell side L
  double depth = 50e-6;              ///< m, slab depth z0
  unsigned int nodes_per_side = 25;  ///< wall nodes per cell side (a cell has 4 times as many)
  double lamella_ratio = 5.;         ///< tie stiffness / tangent stiffness of one wall spring at rest

  NeoHookeanWall wall_law() const { return WallParameters::wall_law(depth); }
  double bending_stiffness() const { return WallParameters::bending_stiffness(depth); }

  /// Declares every entry above in the current subsection of prm.
  void add_parameters(InputEntries &prm);
  /// Throws std::invalid_argument with a sentence for parameters outside their range.
  void check() const;
};
}  // namespace turgor
