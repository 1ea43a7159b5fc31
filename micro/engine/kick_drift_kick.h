// Symplectic kick-drift-kick (velocity Verlet) for inertial scenes.
//
//   v += dt/2 f/m;  x += dt v (and what follows a rate, Term::drift);  f = f(x, v);  v += dt/2 f/m;  impulses
//                   (Term::damp)
//
// A drag sees the velocity of the half step before: that is stable up to drag dt = 2, where a velocity
// predicted at the new time would only reach 1; its lag of dt/2 is w dt/2 of the drag at a motion's
// frequency w, 1e-5 for the motions the scenes resolve.
// The box drifts with H_dot. Forces must be those of the current state when a step begins
// (compute_forces once at the start and after any change from outside).
#pragma once

#include "micro/engine/particle_system.h"

namespace turgor {
template <int dim>
class KickDriftKick {
 public:
  explicit KickDriftKick(ParticleSystem<dim> &system);

  /// damping: velocities (relative to the box's affine flow at zero) are multiplied by exp(-damping dt)
  /// at the end of the step; for relaxing to equilibrium. 0: none.
  void step(double dt, double damping = 0.);

 private:
  ParticleSystem<dim> &system;
};

extern template class KickDriftKick<2>;
extern template class KickDriftKick<3>;
}  // namespace turgor
