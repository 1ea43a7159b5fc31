// Heat in scenes of kick-drift-kick: what damping and the fluid's viscosity take from the motion.
//
//   damping    v <- v exp(-c dt) at the end of a step: E_kin (exp(2 c dt) - 1), exactly, E_kin after the step
//   viscosity  -sum v . f, W; for samples; the forces of its impulses
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/terms/sph_fluid.h"

#include <cmath>

namespace turgor
{
/// J, of the step that has just been taken. dt: s, damping: 1/s.
template <int dim>
double heat_of_damping(const ParticleSystem<dim> &system, const double damping, const double dt)
{
  return damping > 0. ? system.kinetic_energy() * std::expm1(2. * damping * dt) : 0.;
}

/// W, now; after a force evaluation. fluid: null where there is none.
template <int dim>
double heat_of_viscosity(const ParticleSystem<dim> &system, const SphFluid<dim> *fluid)
{
  if (fluid == nullptr || fluid->viscosity() == 0.)
    return 0.;
  const Particles<dim> &p = system.particles;
  double power = 0.;
  for (std::size_t group = 0; group < p.groups.size(); ++group)
    {
      const auto f = fluid->viscous_forces(p, group);
      const std::uint32_t begin = p.groups[group].begin;
      for (int d = 0; d < dim; ++d)
        for (std::size_t i = 0; i < f[d].size(); ++i)
          power -= p.v[d][begin + i] * f[d][i];
    }
  return power;
}
} // namespace turgor
