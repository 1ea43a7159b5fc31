// Breathing of a thin spherical shell, empty or filled with a liquid (thesis A.1).
//
//   empty    omega = sqrt(4 E/rho_s)/R                                                    Eq. A.3 (nu = 1/2);
//            thesis 1 %
//   filled   j0(q)/j1(q) - q rho_s t/(rho R) + 4 E t/(q rho c^2 R) = 0,  q = omega R/c     Eq. A.2; thesis
//            5-10 %
//
// E = 3 G. Both closed forms are linear about a stress-free shell with a liquid at rest pressure 0, and that
// is the start here: turgor 0; the wall, or wall and liquid, get a small inward radial velocity. Decaying
// cosines are fitted to the radial speed of wall and liquid, R sum m v.x/sum m x.x (harmonics.h); a root is
// compared with the largest of those that lie nearer to it than to any other root. K follows from c: c =
// sqrt(7 K/rho).
#pragma once

#include "micro/cells/round_cell.h"
#include "micro/scenes/reference/harmonics.h"
#include "run/scenario.h"

#include <string>
#include <vector>

namespace turgor {
class ShellOscillation final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

  /// rad/s, the first `count` roots of A.2 (rising), or the one of A.3 without fluid.
  static std::vector<double> closed_form(const RoundCellParameters &cell, double radius, double sound_speed,
                                         unsigned int count);

 private:
  RoundCellParameters shell() const;  ///< cell with K from c and no turgor
  /// What of the closed form is found among the harmonics.
  void compare(RunContext &context, const std::vector<Harmonic> &parts, const std::vector<double> &theory,
               double R) const;

  double sound_speed = 50., speed = 0.01, periods = 20., step_fraction = 0.5;
  unsigned int samples_per_period = 400, modes = 4, fitted = 12, checkpoints = 4;
  bool filled = true;
  bool all_struck = true;  ///< else the wall alone
  RoundCellParameters cell;
};

std::unique_ptr<Scenario> make_shell_oscillation();
}  // namespace turgor
