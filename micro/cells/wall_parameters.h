// What a cell's wall is made of (thesis 3.2), for every cell that has one: parenchyma, bricks, round cells.
// Entries are declared once, here.
//
//   struct ParenchymaParameters : WallParameters, FluidParameters { ... };
//   WallParameters wall; wall.declare_wall(prm); ... wall.check_wall();
//   const NeoHookeanWall law = wall.wall_law(depth);
//
// In and out: SI units; depth z0 of a 2D slab in m.
#pragma once

#include "micro/laws/neo_hookean_wall.h"
#include "micro/laws/wall_yield.h"

namespace turgor {
class InputEntries;

struct WallParameters {
  double wall_stiffness = 100.;  ///< N/m, G t0 (thesis 3.2)
  double wall_thickness = 1e-6;  ///< m, t0
  double wall_density = 1300.;   ///< kg/m^3
  double wall_beta = 0.5;        ///< axial over hoop stress, Eq. 3.5 (2D)
  WallYield wall_yield = {};     ///< Eq. 3.8 (2D); no yielding unless a scene asks for it
  bool wall_bending = true;      ///< bending stiffness of the wall's own thickness

  NeoHookeanWall wall_law(const double depth) const {
    return {wall_stiffness, depth, wall_beta, wall_yield};
  }  ///< while it is loaded, yielding included
  /// N m^2, B = E t0^3 z0/12 with E t0 = 4 G t0 (plane strain, incompressible); 0 without bending.
  double bending_stiffness(const double depth) const {
    return wall_bending ? 4. * wall_stiffness * wall_thickness * wall_thickness * depth / 12. : 0.;
  }

  /// Declares every entry above but those of yielding in the current subsection of prm.
  void declare_wall(InputEntries &prm);
  /// Throws std::invalid_argument with a sentence for parameters outside their range.
  void check_wall() const;
};

/// The entries Yield sharpness and Yield drop of a wall that yields (Eq. 3.8).
void declare_yield(InputEntries &prm, WallYield &yield);
}  // namespace turgor
