#include "micro/cells/turgid_network.h"

#include "micro/cells/network_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor
{
TurgidReference turgid_reference(const ParenchymaPatch &patch)
{
  const ParenchymaParameters &p = patch.parameters;
  const ParenchymaPatch cell = make_parenchyma(p, 1, 1, true, true);
  const EquationOfState fluid{p.fluid_density, p.fluid_modulus, p.cavitation_pressure};
  const double volume = p.period * p.period * p.depth;

  HydrostaticNetwork network(cell, fluid.density_at(p.turgor) * volume);
  NetworkEquilibrium equilibrium(network);
  std::vector<double> x = network.reference_positions();
  const double goal = 1e-10 * std::max(p.turgor, 1.);
  double mass = network.fluid_mass();
  // Mean stress over pressure: the bulk modulus decides, so the fluid's own compressibility is a good slope.
  double slope = -fluid.slope(mass / volume) / volume, last_mass = 0., last_stress = 0.;
  bool found = false;
  for (int i = 0; i < 50 && !found; ++i)
    {
      network.set_fluid_mass(mass);
      const EquilibriumReport report = equilibrium.solve(x, cell.lattice, {1e-12, 200});
      // 1e-12 may lie below round-off; what is left must only be small.
      if (!report.converged && !(report.residual < 1e-9))
        throw std::invalid_argument("The turgid reference cell finds no equilibrium: " + report.message);
      const double stress = 0.5 * equilibrium.last_evaluation().virial.total().trace() / volume;
      found = std::abs(stress) <= goal;
      if (found)
        break;
      if (i > 0 && stress != last_stress && mass != last_mass)
        slope = (stress - last_stress) / (mass - last_mass);
      last_mass = mass;
      last_stress = stress;
      mass -= stress / slope;
      // 1e-15 of the mass is 7 K 1e-15 of pressure: nothing better exists
      found = std::abs(mass - last_mass) <= 1e-15 * mass;
      if (found)
        mass = last_mass;
    }
  if (!found)
    throw std::invalid_argument("The fluid mass of the turgid reference cell could not be calibrated.");

  // All cells of a periodic patch are this cell.
  TurgidReference reference;
  reference.fluid_mass = mass;
  reference.positions.reserve(2 * patch.nodes.size());
  for (std::size_t c = 0; c < patch.rings.size(); ++c)
    for (std::uint32_t k = 0; k < patch.rings[c].count; ++k)
      {
        reference.positions.push_back(x[2 * k] + p.period * double(c % patch.columns));
        reference.positions.push_back(x[2 * k + 1] + p.period * double(c / patch.columns));
      }
  return reference;
}
} // namespace turgor
