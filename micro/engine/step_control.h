// The step a scene takes, and when it has to become shorter.
//
//   dt = min( fraction x what the terms bound (Term::rates), fraction x what is measured in the present state
//             (measured_step.h), 0.0045 (1 + 40 nu/(v d)) d/v )      d: particle spacing, v: speed in a cell,
//               nu: viscosity over density
//
// at the start. The first two are of small motions; the last is of collisions, where forces change within a
// step, of the cell that needs the shortest: v is the root mean square against the mean of the cell (single
// particles may be far faster), d the cell's own. Viscosity smooths a collision: from 0.1 Pa s on nothing is
// seen of it up to the speed of sound. Both numbers are from the stability map, doc/results/stability; there
// the energy error binds, not stability. Later the state is looked at again whenever some particle has moved,
// against the mean of its cell, by a particle spacing, but at most every hundredth step: a look costs about
// 20 force evaluations. The step never grows again: every change of it is a small kick to the energy that a
// symplectic step conserves.
#pragma once

#include "micro/engine/particle_system.h"

#include <cstdint>
#include <vector>

namespace turgor {
constexpr double collision_spacings = 0.0045;  ///< a step, see above

template <int dim>
class StepControl {
 public:
  /// Measures the present state.
  /// spacings_a_step: how far the particles of a cell may move in a step (rms), over their spacing;
  /// kinematic_viscosity: m^2/s.
  StepControl(ParticleSystem<dim> &system, double fraction, double spacings_a_step = collision_spacings,
              double kinematic_viscosity = 0.);

  double dt() const { return step; }  ///< s

  /// After the given step (a count from the scene's start). True when dt() has become shorter.
  bool after_step(std::uint64_t count);

  /// dt and the state of the last look, for the same bits after a resume.
  void archive(Archive &a);

 private:
  bool moved() const;
  double step_of_speed() const;  ///< s
  void remember();

  ParticleSystem<dim> *system;  ///< a pointer: a control is replaced when a scene begins anew
  double fraction, spacings_a_step, viscosity, step = 0.;  ///< 1, 1, m^2/s, s
  std::vector<double> spacing;                             ///< m, of the particles of each cell
  typename Particles<dim>::Components looked_at;           ///< m, positions at the last look
};

extern template class StepControl<2>;
extern template class StepControl<3>;
}  // namespace turgor
