// One quasi-static FE^2 run: a piece of tissue followed along its loading (macro/load_path.h) with an RVE at
// every quadrature point. Scenes decide piece, tool, loads and RVE; this does steps, tables, frames,
// checkpoints and results.
//
// Writes steps.csv (forces, travel, failed cells by step), energies.csv (J per metre of depth), tissue.xdmf
// and rve_outlines.csv. After --resume all but the measured times has the same bits as in a run that was
// never stopped.
#pragma once

#include "coupling/rve_law.h"
#include "macro/load_path.h"
#include "run/run_context.h"

#include <memory>

namespace turgor {
class InputEntries;
class Outputs;
struct RveParameters;

struct StaticRunSettings {
  TissueParameters<2> tissue;  ///< with loads and tool
  LoadPathSettings path;
  RveLawSettings law;
  double most_failing = 0.02;  ///< of all cells, in one step
  unsigned int frames = 20, outlined_rves = 6;
  double checkpoint_interval = 60.;  ///< s of wall time
  bool tells_tip = false;            ///< of the middle of the side x = width, as a result

  StaticRunSettings();

  /// Declares subsection "Load steps".
  void declare(InputEntries &prm);
  /// Throws InputError or std::invalid_argument.
  void check(const RveParameters &rve, double sampled = 0.) const;
  /// s, of the way in; in and out with Motion = rebound. load_time: where no tool moves.
  double end_time(double load_time) const;
};

/// Throws RunFailed with place and reason where no further step is found (the last good state is saved and
/// reported), RunStopped.
void run_static(RunContext &context, const StaticRunSettings &settings,
                const std::shared_ptr<const Rve<2>> &rve);

Outputs static_run_outputs();
}  // namespace turgor
