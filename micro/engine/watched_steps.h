// Kick-drift-kick that takes a step in parts where the state has come to need it: a scene keeps its step and
// its count of steps, and a cell that was deformed far (sharp corners, near walls) or moves fast does not
// outgrow them. One part, and the bits of KickDriftKick, as long as the scene's step is below
// StepControl::dt().
#pragma once

#include "micro/engine/kick_drift_kick.h"
#include "micro/engine/step_control.h"

#include <cstdint>

namespace turgor {
template <int dim>
class WatchedSteps {
 public:
  /// As of StepControl. Measures the present state; begin_here() does so again after a change from outside.
  WatchedSteps(ParticleSystem<dim> &system, double fraction, double spacings_a_step = collision_spacings,
               double kinematic_viscosity = 0.);

  void begin_here();

  /// s; what the present state allows.
  double safe_step() const { return control.dt(); }

  /// As KickDriftKick::step; forces must be current.
  void step(double dt, double damping = 0.);

  std::uint64_t extra_steps() const { return extra; }  ///< parts beyond one a step, so far

  void archive(Archive &a);

 private:
  ParticleSystem<dim> &system;
  double fraction, spacings_a_step, viscosity;
  KickDriftKick<dim> plain;
  StepControl<dim> control;
  std::uint64_t count = 0, extra = 0;
};

extern template class WatchedSteps<2>;
extern template class WatchedSteps<3>;
}  // namespace turgor
