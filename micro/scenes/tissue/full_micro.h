// Scene `full_micro`: all cells of a piece of tissue as one particle system, clamped at the
// left, under a body force that is switched on at t = 0 (thesis 3.4.3, Fig. 3.8A left). The reference
// that the coarse runs are compared with: same probes, same tables.
#pragma once

#include "micro/cells/tissue_block.h"
#include "micro/cells/tissue_structure.h"
#include "micro/engine/kick_drift_kick.h"
#include "run/run_context.h"
#include "run/scenario.h"

namespace turgor {
class FullMicro final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;

  CellLayout laid_out() const;  ///< periodic both ways, at turgor

  ParenchymaParameters cell;
  TissueStructure structure;
  SphParameters sph;
  unsigned int columns = 16, rows = 16;
  BlockLoad load;
  double end_time = 0.47e-3;
  double step_fraction = 0.9;
  double window = 0.;  ///< fraction of the steps really run (timing), 0: all
  Surfaces surfaces = Surfaces::frozen;
  unsigned int relax_steps = 20000;
  unsigned int samples = 500, frames = 4, checkpoints = 20;
};

std::unique_ptr<Scenario> make_full_micro();
}  // namespace turgor
