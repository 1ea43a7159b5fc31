#include "micro/cells/fluid_parameters.h"

#include "micro/cells/cell_entry.h"
#include "run/input_entries.h"

namespace turgor {
void FluidParameters::declare_fluid(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Turgor", turgor,
      "Pressure of the cells' fluid above that outside, in undeformed cells at rest. Units: Pa.",
      Double(0., 1e8));
  prm.add_parameter("Fluid density", fluid_density,
                    "Density rho_0 of the fluid without pressure (Eq. 2.22). Units: kg/m^3.",
                    Double(1., 1e5));
  prm.add_parameter("Fluid modulus", fluid_modulus, "K of Eq. 2.22; the bulk modulus is 7 K. Units: Pa.",
                    Double(1e3, 1e10));
  prm.add_parameter("Fluid viscosity", fluid_viscosity,
                    "Dynamic viscosity mu of the cells' fluid (water: 1e-3). Units: Pa s.", Double(0., 1e6));
  prm.add_parameter(
      "Cavitation pressure", cavitation_pressure,
      "Gauge pressure below which the liquid gives way (keeps 1 % of its stiffness). Units: Pa.",
      Double(-1e10, -1e-3));
}

void FluidParameters::check_fluid() const {
  require_cell_entry(turgor >= 0., "Turgor", turgor, "zero or positive (Pa)");
  require_cell_entry(fluid_density > 0., "Fluid density", fluid_density, "positive (kg/m^3)");
  require_cell_entry(fluid_modulus > 0., "Fluid modulus", fluid_modulus, "positive (Pa)");
  require_cell_entry(fluid_viscosity >= 0., "Fluid viscosity", fluid_viscosity, "zero or positive (Pa s)");
  require_cell_entry(cavitation_pressure < 0. && cavitation_pressure > -fluid_modulus, "Cavitation pressure",
                     cavitation_pressure, "negative and above minus the fluid modulus (Pa)");
}
}  // namespace turgor
