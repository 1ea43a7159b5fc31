#include "micro/cells/parenchyma_parameters.h"

#include "run/input_entries.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace turgor
{
void ParenchymaParameters::add_parameters(InputEntries &prm)
{
  using Patterns::Bool;
  using Patterns::Double;
  using Patterns::Integer;
  prm.add_parameter("Period", period, "Side L of the inflated cell. Units: m.", Double(1e-7, 1e-2));
  prm.add_parameter("Depth", depth, "Depth z0 of the slab of tissue out of the plane; forces and masses are proportional to it. Units: m.", Double(1e-8, 1e-1));
  prm.add_parameter("Nodes per side", nodes_per_side,
                    "Wall nodes per cell side; a cell has four times as many. Units: 1.", Integer(2, 1000));
  prm.add_parameter("Wall stiffness", wall_stiffness,
                    "G t0, shear modulus times wall thickness (thesis 3.2); of an incompressible wall with Young's modulus E it is E t0/3. Units: N/m.", Double(1e-6, 1e9));
  prm.add_parameter("Wall thickness", wall_thickness,
                    "Thickness t0 of the wall, which gives it its mass and bending stiffness; Wall stiffness contains it already. Units: m.", Double(1e-9, 1e-3));
  prm.add_parameter("Wall density", wall_density, "Mass of the wall over its volume. Units: kg/m^3.", Double(1., 1e5));
  prm.add_parameter("Wall beta", wall_beta,
                    "Axial over hoop stress of the wall (thesis Eq. 3.5): 0.5 cylinder, 1 cube. Units: 1.",
                    Double(0., 1.));
  prm.add_parameter("Wall bending", wall_bending,
                    "Whether the wall has a bending stiffness, E t0^3/12 with E = 4 G. Without it slack walls have no "
                    "resistance. Units: true or false.",
                    Bool());
  prm.add_parameter("Lamella ratio", lamella_ratio,
                    "Stiffness of a middle-lamella tie over that of one wall spring at rest. Units: 1.",
                    Double(1e-3, 1e6));
  prm.add_parameter("Turgor", turgor, "Pressure of the cells' fluid above that outside, in the undeformed tissue. Units: Pa.",
                    Double(0., 1e8));
  prm.add_parameter("Fluid density", fluid_density, "Density rho_0 of the fluid without pressure (Eq. 2.22). Units: kg/m^3.", Double(1., 1e5));
  prm.add_parameter("Fluid modulus", fluid_modulus,
                    "K of Eq. 2.22; the bulk modulus is 7 K. Units: Pa.", Double(1e3, 1e10));
  prm.add_parameter("Fluid viscosity", fluid_viscosity, "Dynamic viscosity mu of the cells' fluid (water: 1e-3). Units: Pa s.", Double(0., 1e6));
  prm.add_parameter("Cavitation pressure", cavitation_pressure,
                    "Gauge pressure below which the liquid gives way (keeps 1 % of its stiffness). Units: Pa.",
                    Double(-1e10, -1e-3));
}

namespace
{
void require(const bool good, const std::string &entry, const double value, const std::string &allowed)
{
  if (good && std::isfinite(value))
    return;
  std::ostringstream sentence;
  sentence << "Cell/" << entry << " is " << value << ", but it has to be " << allowed << ".";
  throw std::invalid_argument(sentence.str());
}
} // namespace

void ParenchymaParameters::check() const
{
  require(period > 0., "Period", period, "a positive length in m");
  require(depth > 0., "Depth", depth, "a positive length in m");
  require(nodes_per_side >= 2, "Nodes per side", nodes_per_side, "at least 2");
  require(wall_stiffness > 0., "Wall stiffness", wall_stiffness, "positive (N/m)");
  require(wall_thickness > 0. && wall_thickness < 0.5 * period, "Wall thickness", wall_thickness,
          "positive and thinner than half the period (m)");
  require(wall_density > 0., "Wall density", wall_density, "positive (kg/m^3)");
  require(wall_beta >= 0. && wall_beta <= 1., "Wall beta", wall_beta, "between 0 and 1");
  require(lamella_ratio > 0., "Lamella ratio", lamella_ratio, "positive");
  require(turgor >= 0., "Turgor", turgor, "zero or positive (Pa)");
  require(fluid_density > 0., "Fluid density", fluid_density, "positive (kg/m^3)");
  require(fluid_modulus > 0., "Fluid modulus", fluid_modulus, "positive (Pa)");
  require(fluid_viscosity >= 0., "Fluid viscosity", fluid_viscosity, "zero or positive (Pa s)");
  require(cavitation_pressure < 0. && cavitation_pressure > -fluid_modulus, "Cavitation pressure",
          cavitation_pressure, "negative and above minus the fluid modulus (Pa)");
}
} // namespace turgor
