#include "micro/cells/hydrostatic_network.h"

#include "run/start_disturbance.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace turgor
{
namespace
{
EquationOfState equation_of_state(const ParenchymaParameters &p)
{
  return {p.fluid_density, p.fluid_modulus, p.cavitation_pressure};
}
} // namespace

HydrostaticNetwork::HydrostaticNetwork(ParenchymaPatch patch_, const double fluid_mass_)
  : geometry(std::move(patch_))
  , wall(geometry.parameters.wall_stiffness, geometry.parameters.depth, geometry.parameters.wall_beta,
         geometry.parameters.wall_yield)
  , elastic(wall.elastic())
  , fluid{equation_of_state(geometry.parameters)}
  , mass(fluid_mass_)
  , hinge(geometry.bending_stiffness / geometry.spacing)
  , scale(geometry.parameters.turgor * geometry.spacing * geometry.parameters.depth)
{
  // Without turgor, residuals are measured against 1 % of the wall stiffness.
  if (!(scale > 0.))
    scale = 0.01 * geometry.parameters.wall_stiffness * geometry.parameters.depth;
  set_fluid_mass(mass);
  const std::uint32_t side = geometry.parameters.nodes_per_side;
  rest_angle.assign(4 * side, 0.);
  for (std::uint32_t corner = 0; corner < 4; ++corner)
    rest_angle[corner * side] = std::numbers::pi / 2.;
}

void HydrostaticNetwork::set_fluid_mass(const double mass_)
{
  if (!(mass_ > 0.) || !std::isfinite(mass_))
    throw std::invalid_argument("The fluid mass of a cell has to be positive (kg).");
  mass = mass_;
  masses.clear();
}

void HydrostaticNetwork::set_fluid_masses(std::vector<double> masses_)
{
  if (masses_.size() != geometry.rings.size())
    throw std::invalid_argument("Fluid masses need one value per cell.");
  for (const double m : masses_)
    if (!(m > 0.) || !std::isfinite(m))
      throw std::invalid_argument("The fluid mass of a cell has to be positive (kg).");
  masses = std::move(masses_);
}

void HydrostaticNetwork::release_water(const std::vector<double> &volumes)
{
  if (!held)
    throw std::logic_error("No pressure was held, so there is no water to release.");
  const double density = fluid.fluid.density_at(*held);
  std::vector<double> taken_up;
  for (const double volume : volumes)
    taken_up.push_back(density * volume);
  set_fluid_masses(std::move(taken_up));
  held.reset();
}

void HydrostaticNetwork::set_dead_forces(std::vector<double> forces)
{
  if (!forces.empty() && forces.size() != unknowns())
    throw std::invalid_argument("Dead forces need two components per wall node, or none at all.");
  dead = std::move(forces);
}

std::vector<double> HydrostaticNetwork::reference_positions() const
{
  std::vector<double> x;
  x.reserve(unknowns());
  for (const Vector<2> &node : geometry.nodes)
    x.insert(x.end(), {node[0], node[1]});
  if (disturb_start != nullptr)
    disturb_start(0, x);
  return x;
}
} // namespace turgor
