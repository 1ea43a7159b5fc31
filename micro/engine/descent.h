// Descent of the energy to rest, by inertia that is led along the forces (FIRE: Bitzek et al., Phys. Rev.
// Lett. 97, 170201, 2006).
//
// A kick-drift-kick step, then with u = sqrt(m) v and g = f/sqrt(m) over all particles, P = sum f.v:
//
//   P > 0    u <- (1 - a) u + a |u| g/|g|;  a <- 0.99 a after five such steps in a row
//   P <= 0   u <- 0, a <- 0.1: the motion has gone past a minimum
//
// The step stays the one that is given (a stable one; the method of the paper also varies it). Masses only
// set the pace. Where damped motion creeps along the soft directions of a fluid's disorder this gathers
// speed: ten times fewer steps for the shell of 930 particles. Sums run over the particles in order: same
// bits on any number of threads.
#pragma once

#include "micro/engine/kick_drift_kick.h"

namespace turgor {
class Archive;

template <int dim>
class Descent {
 public:
  /// Velocities are set to zero; forces must be those of the state.
  explicit Descent(ParticleSystem<dim> &system);

  void step(double dt);
  void stop();  ///< velocities to zero: begins anew where the state was changed from outside

  void archive(Archive &a);

  unsigned int stops = 0;  ///< steps that went past a minimum; whoever counts them sets it back

 private:
  ParticleSystem<dim> &system;
  KickDriftKick<dim> integrator;
  double share = 0.;  ///< a
  unsigned int downhill = 0;
};

extern template class Descent<2>;
extern template class Descent<3>;
}  // namespace turgor
