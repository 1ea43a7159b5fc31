// Heat in scenes of kick-drift-kick: what damping and the fluid's viscosity take from the motion.
//
//   damping    v <- v exp(-c dt) at the end of a step: E_kin (exp(2 c dt) - 1), exactly, E_kin after the step
//   viscosity  what its impulses have taken, exactly (ParticleSystem::heat)
#pragma once

#include "micro/engine/particle_system.h"

#include <cmath>

namespace turgor {
/// J, of the step that has just been taken. dt: s, damping: 1/s.
template <int dim>
double heat_of_damping(const ParticleSystem<dim> &system, const double damping, const double dt) {
  return damping > 0. ? system.kinetic_energy() * std::expm1(2. * damping * dt) : 0.;
}
}  // namespace turgor
