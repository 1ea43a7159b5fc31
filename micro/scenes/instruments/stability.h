// Scene `stability`: how long a time step one periodic SPH cell really stands, against the step that the
// program chooses by itself. One run is one point of the stability map (inputs/studies/stability.prm).
//
// The annealed cell is brought to F, rests there, and gets the velocities of a disturbance and of a
// collision. From this state the same time T = Hold steps x (step of the program) is run again and again with
// a fixed step; the largest step is found by bisection whose energy error stays below 1e-3: the most that
// potential + kinetic rises above any value it had before, over the energy at the start (drag only takes
// energy).
#pragma once

#include "micro/cells/sph_parenchyma.h"
#include "run/run_context.h"
#include "run/scenario.h"

#include <string>

namespace turgor {
class Stability final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  struct Trial {
    bool stable = false;
    double energy_error = 0.;                ///< over the energy at the start
    double cpu_per_second = 0.;              ///< CPU seconds per simulated second
    double first_step = 0., last_step = 0.;  ///< s
  };

  void deform(RunContext &context, SphPatch &cell) const;
  void disturb(SphPatch &cell) const;
  Trial attempt(RunContext &context, SphPatch &cell, const std::string &start, double fixed,
                double duration) const;  ///< fixed: the step (s), 0: as the program chooses

  ParenchymaParameters cell;
  SphParameters sph;
  std::string F_text = "1, 0; 0, 1";
  double start_speed = 0.1, impact_speed = 0.;  ///< m/s
  double step_fraction = 0.9;
  unsigned int hold_steps = 3000, substeps = 1, bisections = 6;
};

std::unique_ptr<Scenario> make_stability();
}  // namespace turgor
