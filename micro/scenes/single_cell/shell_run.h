// A run of shell_oscillation (thesis A.1): the filled or empty shell comes to rest, is struck inwards and
// swings; its mean radius and radial speed are sampled evenly, in the one loop of scenes that go in steps, so
// that it can be stopped and resumed anywhere.
//
//   ShellRun run(cell, {.speed = 0.01});
//   const ShellMotion &motion = run.go(context, lowest);    writes radius.csv
#pragma once

#include "micro/cells/round_cell.h"
#include "micro/engine/kick_drift_kick.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace turgor {
class RunContext;

struct ShellStrike {
  double speed = 0.01;     ///< m/s, inwards
  bool all_struck = true;  ///< else the wall alone
  double periods = 20.;    ///< of the lowest closed form
  double step_fraction = 0.5;
  unsigned int samples_per_period = 400, checkpoints = 4;
};

struct ShellMotion {
  double rest_radius = 0., sampling = 0.;  ///< m, s
  double energy_drift = 0.;                ///< relative
  double crossed = 0.;                     ///< most particles outside at once
  std::vector<double> time, speed;         ///< s, m/s (radial)
};

class ShellRun {
 public:
  ShellRun(const RoundCellParameters &cell, const ShellStrike &strike);

  /// lowest: rad/s, of the closed form of a shell of that radius at rest (m). Throws RunFailed where it
  /// diverges.
  const ShellMotion &go(RunContext &context, const std::function<double(double radius)> &lowest);

  std::size_t fluid_particles() const { return round->group().fluid_count(); }

 private:
  void begin(RunContext &context);

  const ShellStrike strike;
  std::unique_ptr<RoundCell<3>> round;
  KickDriftKick<3> integrator;
  std::uint64_t step = 0;  ///< samples taken after the first
  double start_energy = 0.;
  std::uint64_t per_sample = 0;  ///< steps of the integrator
  ShellMotion motion;
};
}  // namespace turgor
