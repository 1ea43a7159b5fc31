// Scene `invasion`: a round colony of cells of the rod model, up to tens of thousands, that pull themselves
// and each other into a random fibre network around it (thesis 6.4 and 7.2.2 II): how far and how many, over
// time.
#pragma once

#include "micro/scenes/matrix/trial_entries.h"
#include "run/scenario.h"

namespace turgor {
class Invasion : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  TrialEntries entries = [] {
    TrialEntries e;
    e.trial.cells = 200;
    e.trial.matrix.repeated = true;
    e.trial.matrix.side = 4e-4;
    return e;
  }();
  double end_time = 3600.;
  unsigned int seed = 1, samples = 60, frames = 3;
};

std::unique_ptr<Scenario> make_invasion();
}  // namespace turgor
