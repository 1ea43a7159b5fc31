// The fluid of a cell and the pressure it has at rest (thesis 3.2, Eq. 2.22), for every cell that has one.
// Entries are declared once, here.
//
//   FluidParameters fluid; fluid.declare_fluid(prm); ... fluid.check_fluid();
//   const double density = fluid.equation_of_state().density_at(fluid.turgor);
//
// In and out: SI units.
#pragma once

#include "micro/laws/equation_of_state.h"

namespace turgor {
class InputEntries;

struct FluidParameters {
  double turgor = 200e3;          ///< Pa, above the pressure outside
  double fluid_density = 1000.;   ///< kg/m^3, rho_0
  double fluid_modulus = 6e6;     ///< Pa, K of the EOS (2.22); bulk modulus is 7 K
  double fluid_viscosity = 1e-3;  ///< Pa s
  double cavitation_pressure =
      -100e3;  ///< Pa gauge, where liquid gives way (see micro/laws/equation_of_state.h)

  EquationOfState equation_of_state() const { return {fluid_density, fluid_modulus, cavitation_pressure}; }

  /// Declares every entry above in the current subsection of prm.
  void declare_fluid(InputEntries &prm);
  /// Throws std::invalid_argument with a sentence for parameters outside their range.
  void check_fluid() const;
};
}  // namespace turgor
