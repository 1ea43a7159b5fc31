// What an RVE of SPH cells is and how long it may take; the entries are in rve_parameters.cc.
#pragma once

#include "micro/cells/sph_parenchyma.h"

namespace turgor {
enum class SphRule { cauchy_born, elastic_equilibrium, constrained_runs };

struct SphRveSettings {
  SphRule rule = SphRule::constrained_runs;
  unsigned int columns = 1, rows = 1;
  SphParameters sph;
  double step_fraction = 0.9;  ///< of the stable step
  double burst = 2e-7;         ///< s, tau
  unsigned int bursts = 1;
  double window = 1e-7;     ///< s, tau_0
  double tolerance = 1e-3;  ///< elastic_equilibrium: largest unbalanced force / (turgor spacing depth)
  unsigned int relax_steps =
      2000;  ///< elastic_equilibrium: at most, for a change of F that is one jump (sph_motion.h)
};
}  // namespace turgor
