// Symplectic kick-drift-kick (velocity Verlet) for inertial scenes.
//
//   v += dt/2 f/m;  x += dt v;  f = f(x, v*);  v += dt/2 f/m
//
// A drag that depends on velocity sees v* = v + dt/2 f_old/m, the velocity predicted at the
// new time (second order). v* is kept only if some term declared the fields velocity_now_x/y/z.
// The box drifts with H_dot. Forces must be those of the current state when a step begins
// (compute_forces once at the start and after any change from outside).
#pragma once

#include "micro/engine/particle_system.h"

namespace turgor
{
template <int dim>
class KickDriftKick
{
public:
  explicit KickDriftKick(ParticleSystem<dim> &system);

  /// damping: velocities (relative to the box's affine flow at zero) are multiplied by exp(-damping dt)
  /// at the end of the step; for relaxing to equilibrium. 0: none.
  void step(double dt, double damping = 0.);

  /// v* = v, for a compute_forces() outside a step.
  void set_velocity_now();

private:
  ParticleSystem<dim> &system;
  std::vector<double> *now[dim];
};

extern template class KickDriftKick<2>;
} // namespace turgor
