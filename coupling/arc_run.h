// A piece of tissue followed along its path of equilibria by arc length (macro/arc_length.h), with an RVE at
// every quadrature point: past the load where walls buckle or break and it can carry no more, down to where
// it carries more again. Dead loads only (body force, traction); no time passes, so nothing leaks.
//
// Ends where all of the loads are on, where the side x = width has gone `furthest`, or after so many steps.
// Writes path.csv (share of the loads over displacement, energies in J per metre of depth, by step) and
// tissue.xdmf. After --resume all but the measured time has the same bits as in a run that was never stopped.
#pragma once

#include "coupling/static_run.h"
#include "macro/arc_length.h"

namespace turgor {
struct ArcRunSettings {
  double first_share = 0.02;       ///< of the loads, that the first step aims at
  double longest = 0.01;           ///< of the width: root mean square of the displacement in a step
  double furthest = 0.5;           ///< of the width: mean displacement of the side x = width at the end
  unsigned int most_steps = 1000;  ///< after which the run ends

  /// Declares subsection "Arc length".
  void declare(InputEntries &prm);
  /// Throws InputError.
  void check(const TissueParameters<2> &tissue) const;
};

/// Of `common`: tissue, law, frames, checkpoints, and Newton's method. Throws RunFailed where the path is
/// lost (what was reached is saved and reported), RunStopped.
void run_arc(RunContext &context, const ArcRunSettings &settings, const StaticRunSettings &common,
             const std::shared_ptr<const Rve<2>> &rve);

Outputs arc_run_outputs();
}  // namespace turgor
