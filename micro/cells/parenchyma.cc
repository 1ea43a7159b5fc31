#include "micro/cells/parenchyma.h"

#include "run/input_entries.h"
#include "micro/laws/neo_hookean_wall.h"

#include <cmath>
#include <limits>
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

void check(const ParenchymaParameters &p)
{
  require(p.period > 0., "Period", p.period, "a positive length in m");
  require(p.depth > 0., "Depth", p.depth, "a positive length in m");
  require(p.nodes_per_side >= 2, "Nodes per side", p.nodes_per_side, "at least 2");
  require(p.wall_stiffness > 0., "Wall stiffness", p.wall_stiffness, "positive (N/m)");
  require(p.wall_thickness > 0. && p.wall_thickness < 0.5 * p.period, "Wall thickness", p.wall_thickness,
          "positive and thinner than half the period (m)");
  require(p.wall_density > 0., "Wall density", p.wall_density, "positive (kg/m^3)");
  require(p.wall_beta >= 0. && p.wall_beta <= 1., "Wall beta", p.wall_beta, "between 0 and 1");
  require(p.lamella_ratio > 0., "Lamella ratio", p.lamella_ratio, "positive");
  require(p.turgor >= 0., "Turgor", p.turgor, "zero or positive (Pa)");
  require(p.fluid_density > 0., "Fluid density", p.fluid_density, "positive (kg/m^3)");
  require(p.fluid_modulus > 0., "Fluid modulus", p.fluid_modulus, "positive (Pa)");
  require(p.fluid_viscosity >= 0., "Fluid viscosity", p.fluid_viscosity, "zero or positive (Pa s)");
  require(p.cavitation_pressure < 0. && p.cavitation_pressure > -p.fluid_modulus, "Cavitation pressure",
          p.cavitation_pressure, "negative and above minus the fluid modulus (Pa)");
}
} // namespace

ParenchymaPatch make_parenchyma(const ParenchymaParameters &parameters, const unsigned int columns,
                                const unsigned int rows, const bool periodic_x, const bool periodic_y)
{
  check(parameters);
  require(columns >= 1, "Columns", columns, "at least 1");
  require(rows >= 1, "Rows", rows, "at least 1");
  const std::uint32_t n = parameters.nodes_per_side, ring = 4 * n;
  require(double(columns) * rows * ring < double(std::numeric_limits<std::uint32_t>::max()), "Nodes per side",
          n, "small enough for fewer than 2^32 wall nodes in the patch");

  ParenchymaPatch patch;
  patch.parameters = parameters;
  patch.columns = columns;
  patch.rows = rows;
  patch.periodic_x = periodic_x;
  patch.periodic_y = periodic_y;
  const double L = parameters.period;
  patch.lattice << columns * L, 0., 0., rows * L;
  patch.spacing = L / n;

  const NeoHookeanWall wall(parameters.wall_stiffness, parameters.depth, parameters.wall_beta, parameters.wall_yield);
  patch.lambda_0 = wall.stretch_at(0.5 * parameters.turgor * L * parameters.depth);
  patch.rest_length = patch.spacing / patch.lambda_0;
  patch.node_mass =
    parameters.wall_density * parameters.wall_thickness * parameters.depth * patch.spacing;
  patch.tie_stiffness = parameters.lamella_ratio * wall.derivative(1.) / patch.rest_length;
  // E t0^3 z0/12 with E t0 = 4 G t0
  patch.bending_stiffness = parameters.wall_bending ? 4. * parameters.wall_stiffness *
                                                        parameters.wall_thickness *
                                                        parameters.wall_thickness * parameters.depth / 12. :
                                                      0.;

  for (unsigned int j = 0; j < rows; ++j)
    for (unsigned int i = 0; i < columns; ++i)
      {
        patch.rings.push_back({static_cast<std::uint32_t>(patch.nodes.size()), ring});
        // Grid lines from the integers, so that facing walls share their coordinates bit for bit.
        const auto node = [&](const std::uint32_t a, const std::uint32_t b) {
          patch.nodes.push_back({(double(i) * n + a) * patch.spacing, (double(j) * n + b) * patch.spacing});
        };
        for (std::uint32_t k = 0; k < n; ++k)
          node(k, 0);
        for (std::uint32_t k = 0; k < n; ++k)
          node(n, k);
        for (std::uint32_t k = 0; k < n; ++k)
          node(n - k, n);
        for (std::uint32_t k = 0; k < n; ++k)
          node(0, n - k);
      }

  for (unsigned int j = 0; j < rows; ++j)
    for (unsigned int i = 0; i < columns; ++i)
      {
        const std::uint32_t here = patch.rings[j * columns + i].first;
        const bool last_column = i + 1 == columns, last_row = j + 1 == rows;
        if (!last_column || periodic_x)
          {
            const std::uint32_t right = patch.rings[j * columns + (last_column ? 0 : i + 1)].first;
            for (std::uint32_t k = 0; k <= n; ++k)
              patch.ties.push_back({here + n + k, right + (ring - k) % ring, {{last_column ? 1 : 0, 0}}});
          }
        if (!last_row || periodic_y)
          {
            const std::uint32_t above = patch.rings[(last_row ? 0 : j + 1) * columns + i].first;
            for (std::uint32_t k = 0; k <= n; ++k)
              patch.ties.push_back({here + 2 * n + k, above + n - k, {{0, last_row ? 1 : 0}}});
          }
      }
  return patch;
}
} // namespace turgor
