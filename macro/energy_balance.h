// Where the energy of a tissue is, and the test that none came from nothing. One definition for every run:
//
//   kinetic + stored + contact + dissipated = work          dissipated = heat + spent + unexplained
//
// dissipated is what is missing; heat (viscosity, its power over time) and spent (flow, breaking walls) are what the law itself says it
// has taken; unexplained is the rest: the error of the time stepping, and what the law does not know.
//
// Central differences do not conserve 1/2 m v^2 with the velocity at the nodes of time, but
//   1/2 m v(t - h/2) . v(t + h/2) = 1/2 m v^2 - h^2/8 m a^2,
// with work by the trapezoidal rule exactly: elements that swing near the limit of stability lend a share of their energy to and
// fro (at the limit all of it). `step` is the sum of h^2/8 m change(a^2) over the steps, which dissipated does not count: a
// step load then dissipates nothing in an elastic block at any stable step.
//
// In 2D all is per metre of depth (J/m).
//
//   EnergyCheck check;                                        // after every step:
//   check.update(tissue.energies());
//   if (!check.complaint().empty()) throw RunFailed(check.complaint());
#pragma once

#include <string>

namespace turgor
{
struct TissueEnergies
{
  double kinetic = 0.; ///< J (2D: per metre of depth)
  double stored = 0.;  ///< J, elastic, since rest; signalling NaN if the law does not tell
  double contact = 0.; ///< J, in the penalty of the tools
  double work = 0.;    ///< J, done by body force, traction and tools since rest
  double heat = 0.;    ///< J, by viscosity and by what breaks or flows; signalling NaN if the law does not tell
  double step = 0.;    ///< J, see above

  double dissipated() const { return work + step - kinetic - stored - contact; }
  double unexplained() const { return dissipated() - heat; }
};

/// Plain data: goes into checkpoints as it is.
class EnergyCheck
{
public:
  static constexpr double allowed = 1e-3; ///< share of the largest work so far that may appear from nothing

  void update(const TissueEnergies &now);

  /// Least dissipated energy over the largest work so far; 0 before any work.
  double dissipated_share() const;

  /// A sentence where energy came from nothing; empty where it did not.
  std::string complaint() const;

private:
  double work = 0.; // J, largest so far
  TissueEnergies last;
};
} // namespace turgor
