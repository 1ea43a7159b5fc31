// Water through the cell wall: dm/dt = -rho A L_p (P + Pi) per cell, shared by its
// particles (thesis Eq. 3.2, corrected). Here in the form that relaxation uses: A L_p sets a rate, and the
// cell is filled until its mean pressure P equals -Pi.
//
//   (1/m) dm/dt = rate (P_target - P) / (7 K),   rate in 1/s
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/terms/cell_fluid.h"

namespace turgor {
class Osmosis {
 public:
  /// target: mean EOS pressure (Pa) at which transport stops; rate: 1/s; bulk modulus 7 K (Pa).
  Osmosis(const double target_, const double rate_, const double bulk_modulus_)
      : target(target_), rate(rate_), bulk_modulus(bulk_modulus_) {}

  /// Transport over dt (s) into every cell.
  template <int dim>
  void apply(ParticleSystem<dim> &system, CellFluid<dim> &fluid, const double dt) const {
    for (std::size_t group = 0; group < system.particles.groups.size(); ++group) {
      const double gain = rate * dt * (target - fluid.mean_pressure(system.particles, group)) / bulk_modulus;
      fluid.set_particle_mass(system.particles, group, fluid.particle_mass()[group] * (1. + gain));
    }
  }

 private:
  double target, rate, bulk_modulus;
};
}  // namespace turgor
