// What a scene needs of the fluid in closed cells, whatever its formulation: masses (osmosis,
// calibration), pressure, neighbour lists, and the history that it carries beside positions and velocities.
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/equation_of_state.h"

#include <string>
#include <vector>

namespace turgor {
template <int dim>
class CellFluid : public Term<dim> {
 public:
  /// kg of one fluid particle, per group.
  virtual const std::vector<double> &particle_mass() const = 0;
  /// Changes the mass of the group's particles, here and in inverse_mass.
  virtual void set_particle_mass(Particles<dim> &particles, std::size_t group, double value) = 0;
  virtual const EquationOfState &equation_of_state() const = 0;
  virtual double support() const = 0;  ///< m, kernel radius

  /// Mean of the particles' EOS pressure, Pa; after add_forces.
  double mean_pressure(const Particles<dim> &particles, const std::size_t group) const {
    const Group &g = particles.groups[group];
    const std::vector<double> &p = particles.field("pressure");
    double total = 0.;
    for (std::uint32_t i = g.fluid; i < g.end; ++i) total += p[i];
    return total / g.fluid_count();
  }

  /// Names of the fields that later forces depend on; empty where positions say it all.
  virtual std::vector<std::string> history() const { return {}; }

  /// Positions were changed at once, from `before` (m), without time passing: brings the history along.
  virtual void jumped(Particles<dim> &, const typename Particles<dim>::Components & /*before*/) {
    forget_lists();
  }

  /// The next force evaluation builds all lists anew, whatever came before.
  virtual void forget_lists() = 0;

  /// Particles found outside their wall, all groups.
  virtual std::size_t crossed() const = 0;
  virtual std::size_t list_builds() const = 0;
  /// Neighbours per particle within the support (not the skin), and bytes held.
  virtual double mean_neighbours(const Particles<dim> &particles) const = 0;
  virtual std::size_t memory_bytes() const = 0;
};
}  // namespace turgor
