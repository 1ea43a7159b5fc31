// The step a scene takes, and when it has to become shorter.
//
//   dt = min( fraction x what the terms bound (Term::rates), fraction x what is measured in the present state
//             (measured_step.h), 0.01 x particle spacing / fastest particle, against the mean of its cell )
//
// at the start. The first two are of small motions; the last is of collisions, where forces change within a step (0.01: from the stability map,
// doc/results/stability). Later the state is looked at again whenever some particle has moved, against the mean of its cell, by a particle spacing, but at most every
// hundredth step: a look costs about 20 force evaluations. The step never grows again: every change of it is a small
// kick to the energy that a symplectic step conserves.
#pragma once

#include "micro/engine/particle_system.h"

#include <cstdint>

namespace turgor
{
template <int dim>
class StepControl
{
public:
  /// Measures the present state.
  /// spacings_a_step: how far the fastest particle may move in a step, over the particle spacing.
  StepControl(ParticleSystem<dim> &system, double fraction, double spacings_a_step = 0.01);

  double dt() const { return step; } ///< s

  /// After the given step (a count from the scene's start). True when dt() has become shorter.
  bool after_step(std::uint64_t count);

  /// dt and the state of the last look, for the same bits after a resume.
  void save(std::ostream &out) const;
  void load(std::istream &in);

private:
  bool moved() const;
  double step_of_speed() const; ///< s
  void remember();

  ParticleSystem<dim> *system; ///< a pointer: a control is replaced when a scene begins anew
  double fraction, spacings_a_step, step = 0., spacing = 0.; ///< 1, 1, s, m
  typename Particles<dim>::Components looked_at; ///< m, positions at the last look
};

extern template class StepControl<2>;
extern template class StepControl<3>;
} // namespace turgor
