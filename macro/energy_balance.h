// Where the energy of a tissue is, and the test that none came from nothing. One definition for every run:
//
//   kinetic + stored + contact + dissipated = work          dissipated: what is missing
//
// What the law has really taken differs from that by what the steps have lent: central differences conserve
// not 1/2 m v^2 with the velocity at the nodes of time, but
//   1/2 m v(t - h/2) . v(t + h/2) = 1/2 m v^2 - h^2/8 m a^2,
// with all work by the trapezoidal rule, exactly. So elements that swing near the limit of stability lend a
// share of their energy to and fro, at the limit all of it; an elastic block dissipates nothing in
//   taken = dissipated + lent,   lent = sum over the steps of h^2/8 m change(a^2),
// at any stable step. Of that the law itself explains heat: the work of viscous stress, by the same rule, and
// what flows or breaks. So
//   unexplained = taken - heat
// is what the steps err by where a law is not linear within a step, either way, and what a law takes or makes
// without telling.
//
// In 2D all is per metre of depth (J/m).
//
//   EnergyCheck check;                                        // after every step:
//   check.update(tissue.energies());
//   if (!check.complaint().empty()) throw RunFailed(check.complaint());
#pragma once

#include <string>

namespace turgor {
struct TissueEnergies {
  double kinetic = 0.;  ///< J (2D: per metre of depth)
  double stored = 0.;   ///< J, elastic, since rest; signalling NaN if the law does not tell
  double contact = 0.;  ///< J, in the penalty of the tools
  double work = 0.;     ///< J, done by body force, traction and tools since rest
  double heat = 0.;     ///< J, by viscosity, flow and breaking; signalling NaN if the law does not tell
  double lent = 0.;     ///< J, by the steps

  double dissipated() const { return work - kinetic - stored - contact; }
  double taken() const { return dissipated() + lent; }
};

/// Plain data: goes into checkpoints as it is.
class EnergyCheck {
 public:
  static constexpr double allowed = 1e-3;  ///< share of the largest work so far that a law may give
  static constexpr double allowed_unexplained =
      0.02;  ///< share of the largest work so far, either way, where the law tells of its heat
  static constexpr double allowed_lent =
      0.25;  ///< the same for what steps have lent besides: more is a step that is not stable

  /// resolution: J, energies that are not judged (strains of 1e-6: round-off, tolerances of the law).
  explicit EnergyCheck(double resolution_ = 0.) : resolution(resolution_) {}

  void update(const TissueEnergies &now);

  /// What the law has taken over the largest work so far; 0 before any work.
  double taken_share() const { return share(last.taken()); }
  double heat_share() const { return share(last.heat); }  ///< what the law explains; NaN if it does not tell
  double unexplained_share() const { return taken_share() - heat_share(); }

  /// A sentence where energy came from nothing or went nobody knows where; empty where it did not.
  std::string complaint() const;

  /// More has come from nothing than was ever put in: no use in going on.
  bool hopeless() const;

 private:
  double share(double energy) const { return work > 0. ? energy / work : 0.; }

  double resolution;
  double work = 0.;  // J, largest so far
  TissueEnergies last;
};
}  // namespace turgor
