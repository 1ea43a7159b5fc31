// What walls and fluid of a parenchyma cell are made of (thesis 3.2) and how finely it is resolved: the entries of the subsection Cell.
//
// A 2D scene is a slab of depth z0: masses, forces and energies are those of the slab. SI units.
#pragma once

#include "micro/laws/equation_of_state.h"
#include "micro/laws/neo_hookean_wall.h"
#include "micro/laws/wall_yield.h"

namespace turgor
{
class InputEntries;
/// Physical parameters of a parenchyma cell (thesis 3.2); SI units.
struct ParenchymaParameters
{
  double period = 100e-6;           ///< m, inflated cell side L
  double depth = 50e-6;             ///< m, slab depth z0
  unsigned int nodes_per_side = 25; ///< wall nodes per cell side (a cell has 4 times as many)
  double wall_stiffness = 100.;     ///< N/m, G t0 (thesis 3.2)
  double wall_thickness = 1e-6;     ///< m, t0
  double wall_density = 1300.;      ///< kg/m^3
  double wall_beta = 0.5;           ///< axial over hoop stress, Eq. 3.5
  WallYield wall_yield = {};        ///< Eq. 3.8; no yielding unless a scene asks for it
  bool wall_bending = true;         ///< bending stiffness E t^3/12 of the wall, E = 4 G (plane strain, incompressible)
  double lamella_ratio = 5.;        ///< tie stiffness / tangent stiffness of one wall spring at rest
  double turgor = 200e3;            ///< Pa
  double fluid_density = 1000.;     ///< kg/m^3, rho_0
  double fluid_modulus = 6e6;       ///< Pa, K of the EOS (2.22); bulk modulus is 7 K
  double fluid_viscosity = 1e-3;    ///< Pa s
  double cavitation_pressure = -100e3; ///< Pa gauge, where liquid gives way (see micro/laws/equation_of_state.h)

  NeoHookeanWall wall_law() const { return {wall_stiffness, depth, wall_beta, wall_yield}; } ///< while it is loaded, yielding included
  EquationOfState equation_of_state() const { return {fluid_density, fluid_modulus, cavitation_pressure}; }
  double bending_stiffness() const ///< N m^2, B = E t0^3 z0/12 with E t0 = 4 G t0
  {
    return wall_bending ? 4. * wall_stiffness * wall_thickness * wall_thickness * depth / 12. : 0.;
  }

  /// Declares every entry above in the current subsection of prm.
  void add_parameters(InputEntries &prm);
  /// Throws std::invalid_argument with a sentence for parameters outside their range.
  void check() const;
};
} // namespace turgor
