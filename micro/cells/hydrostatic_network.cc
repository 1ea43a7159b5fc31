#include "micro/cells/hydrostatic_network.h"

#include "micro/cells/air_spaces.h"
#include "micro/cells/ring_geometry.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace turgor {
HydrostaticNetwork::HydrostaticNetwork(CellLayout layout)
    : geometry(std::move(layout)),
      wall(geometry.parameters.wall_law()),
      elastic(wall.elastic()),
      fluid{geometry.parameters.equation_of_state()},
      scale(geometry.parameters.turgor * geometry.spacing * geometry.parameters.depth),
      bending(std::any_of(geometry.hinge.begin(), geometry.hinge.end(),
                          [](const double hinge) { return hinge > 0.; })),
      air(geometry) {
  geometry.check();
  // Without turgor, residuals are measured against 1 % of the wall stiffness.
  if (!(scale > 0.)) scale = 0.01 * geometry.parameters.wall_stiffness * geometry.parameters.depth;
  for (const double length : geometry.rest_length) inverse_rest.push_back(1. / length);
}

void HydrostaticNetwork::set_fluid_masses(std::vector<double> masses) {
  if (masses.size() != geometry.cells()) throw std::invalid_argument("Fluid masses need one value per cell.");
  for (const double m : masses)
    if (!(m > 0.) || !std::isfinite(m))
      throw std::invalid_argument("The fluid mass of a cell has to be positive (kg).");
  geometry.fluid_mass = std::move(masses);
}

void HydrostaticNetwork::release_water(const std::vector<double> &volumes) {
  if (!held) throw std::logic_error("No pressure was held, so there is no water to release.");
  const double density = fluid.fluid.density_at(*held);
  std::vector<double> taken_up;
  for (const double volume : volumes) taken_up.push_back(density * volume);
  set_fluid_masses(std::move(taken_up));
  held.reset();
}

double HydrostaticNetwork::air_share(const std::vector<double> &x, const Tensor2<2> &H) const {
  if (geometry.air.empty()) return 0.;
  double cells = 0.;
  for (const WallRing &ring : geometry.rings) cells += polygon_area(x, ring);
  return 1. - cells / H.determinant();
}

void HydrostaticNetwork::shut_air(const AirGasLaw &law) {
  gas = AirGas(air, law, depth());
  gas.shut(geometry.positions(), geometry.lattice);
}

bool HydrostaticNetwork::air_lost(const std::vector<double> &x, const Tensor2<2> &H) const {
  return std::any_of(geometry.air.begin(), geometry.air.end(), [&](const AirSpace &space) {
    return air_area(geometry, space, x, H) < -2. * air.law().inset * air_rim(geometry, space, x);
  });
}

void HydrostaticNetwork::set_dead_forces(std::vector<double> forces) {
  if (!forces.empty() && forces.size() != unknowns())
    throw std::invalid_argument("Dead forces need two components per wall node, or none at all.");
  dead = std::move(forces);
}
}  // namespace turgor
