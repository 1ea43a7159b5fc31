// The largest stable step of kick-drift-kick in the present state, measured from the forces themselves.
//
// With half-step drag the step is stable while dt^2 w^2 + 2 dt d < 4 for all motions (Rates in term.h), that
// is, while
//   lambda(dt) = largest eigenvalue of M^-1/2 (dt^2 K + 2 dt D) M^-1/2 < 4,   K = -df/dx, D = -df/dv.
// One force evaluation at x + e dt^2 u, v + 2 e dt u gives the product with a vector u; Lanczos' method needs
// about 20 of them for lambda to 1 % (from below), and dt with lambda(dt) = 4 is found from three or four
// such lambdas. This knows nothing of the laws, so it holds for any terms in any deformed state, where bounds
// by hand (Term::rates) are for the state they were derived in. What is not in touch now (a plate that is
// still away) is not seen.
//
// Positions, velocities and forces are left as they were, bit for bit (a neighbour list that was about to be
// built anew may be built one step earlier). The same on any number of threads.
#pragma once

#include "micro/engine/particle_system.h"

namespace turgor {
struct MeasuredStep {
  double dt = 0.;                ///< s; infinite where nothing resists
  unsigned int evaluations = 0;  ///< of all forces
};

/// start: where the search begins (s), for example stable_time_step(); pace: of these terms alone.
template <int dim>
MeasuredStep measure_stable_step(ParticleSystem<dim> &system, double start, Pace pace = Pace::all);

/// lambda(dt); dt is stable while it is below 4. Not finite where the forces are not.
template <int dim>
double step_eigenvalue(ParticleSystem<dim> &system, double dt, Pace pace = Pace::all);

extern template double step_eigenvalue<2>(ParticleSystem<2> &, double, Pace);
extern template double step_eigenvalue<3>(ParticleSystem<3> &, double, Pace);
extern template MeasuredStep measure_stable_step<2>(ParticleSystem<2> &, double, Pace);
extern template MeasuredStep measure_stable_step<3>(ParticleSystem<3> &, double, Pace);
}  // namespace turgor
