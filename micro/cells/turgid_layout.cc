#include "micro/cells/turgid_layout.h"

#include "micro/cells/network_equilibrium.h"
#include "micro/cells/parenchyma.h"
#include "run/start_disturbance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor
{
CellLayout turgid(CellLayout layout)
{
  const ParenchymaParameters &p = layout.parameters;
  const double volume = layout.lattice.determinant() * p.depth;
  HydrostaticNetwork network(layout);
  NetworkEquilibrium equilibrium(network);
  std::vector<double> x = layout.positions();
  if (disturb_start != nullptr)
    disturb_start(0, x);
  const double goal = 1e-10 * std::max(p.turgor, 1.);
  double mass = layout.total_fluid_mass(); // of all cells, shared out as in the beginning
  std::vector<double> share = layout.fluid_mass;
  for (double &s : share)
    s /= mass;
  // Mean stress over pressure: the bulk modulus decides, so the fluid's own compressibility is a good slope.
  double slope = -p.equation_of_state().slope(mass / volume) / volume, last_mass = 0., last_stress = 0.;
  bool found = false;
  for (int i = 0; i < 50 && !found; ++i)
    {
      for (std::size_t c = 0; c < layout.cells(); ++c)
        layout.fluid_mass[c] = share[c] * mass;
      network.set_fluid_masses(layout.fluid_mass);
      const EquilibriumReport report = equilibrium.solve(x, layout.lattice, {1e-12, 200});
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
    }
  if (!found)
    throw std::invalid_argument("The fluid mass of the turgid reference cell could not be calibrated.");
  layout.set_positions(x);
  return layout;
}

CellLayout turgid_parenchyma(const ParenchymaParameters &parameters, const unsigned int columns, const unsigned int rows,
                             const bool periodic_x, const bool periodic_y)
{
  CellLayout layout = make_parenchyma(parameters, columns, rows, periodic_x, periodic_y);
  const CellLayout cell = turgid(make_parenchyma(parameters, 1, 1, true, true));
  for (std::size_t c = 0; c < layout.cells(); ++c)
    {
      const Vector<2> at(parameters.period * double(c % columns), parameters.period * double(c / columns));
      for (std::size_t k = 0; k < cell.nodes.size(); ++k)
        layout.nodes[layout.rings[c].first + k] = cell.nodes[k] + at;
      layout.fluid_mass[c] = cell.fluid_mass[0];
    }
  return layout;
}
} // namespace turgor
