// Scene `rod_migration`: single cells of the rod model that pull themselves through a random fibre network by
// their protrusions (thesis 6.4, Fig. 6.3), one for each seed: how far they come, against pore size,
// degradation, nucleus and stiffness.
#pragma once

#include "micro/scenes/matrix/trial_entries.h"
#include "run/scenario.h"

namespace turgor {
class RodMigration : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  TrialEntries entries;
  double end_time = 7200.;
  unsigned int seeds = 5, first_seed = 1, samples = 120, frames = 3;
};

std::unique_ptr<Scenario> make_rod_migration();
}  // namespace turgor
