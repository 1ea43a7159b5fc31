// Kick-drift-kick or, with substeps, r-RESPA behind one face: what a scene with the entry `Substeps` steps
// with.
#pragma once

#include "micro/engine/kick_drift_kick.h"
#include "micro/engine/respa.h"

#include <optional>

namespace turgor {
template <int dim>
class Stepper {
 public:
  /// substeps: of the fast terms in a step; 1: kick-drift-kick.
  Stepper(ParticleSystem<dim> &system_, const unsigned int substeps) : system(system_), plain(system_) {
    if (substeps > 1) split.emplace(system_, substeps);
  }

  /// At the start and after any change from outside.
  void compute_forces() { split ? split->compute_forces() : system.compute_forces(); }
  void step(const double dt, const double damping = 0.) {
    split ? split->step(dt, damping) : plain.step(dt, damping);
  }

 private:
  ParticleSystem<dim> &system;
  KickDriftKick<dim> plain;
  std::optional<Respa<dim>> split;
};
}  // namespace turgor
