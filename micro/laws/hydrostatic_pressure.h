// Fluid of a closed cell that has come to rest: one pressure from the cell's volume.
//
//   E = m e(rho),  rho = m/V,  dE/dV = -p(rho),  d2E/dV2 = rho c^2 / V
//
// with e, p, c of equation_of_state.h (thesis Eq. 2.22). In: V (m^3), m (kg). Out: J, Pa, Pa/m^3.
#pragma once

#include "micro/laws/equation_of_state.h"

namespace turgor {
struct HydrostaticPressure {
  EquationOfState fluid;

  double energy(const double mass, const double volume) const {
    return volume > 0. ? mass * fluid.energy(mass / volume) : HUGE_VAL;
  }
  double pressure(const double mass, const double volume) const { return fluid.pressure(mass / volume); }

  /// d2E/dV2, Pa/m^3.
  double stiffness(const double mass, const double volume) const {
    const double rho = mass / volume;
    return rho * fluid.slope(rho) / volume;
  }
};
}  // namespace turgor
