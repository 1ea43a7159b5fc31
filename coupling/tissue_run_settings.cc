#include "coupling/tissue_run.h"
#include "coupling/tissue_size.h"
#include "run/input_entries.h"
#include "rve/make_rve.h"

namespace turgor {
void TissueRunSettings::declare(InputEntries &prm, RveParameters &rve, const bool with_size_and_body_force) {
  prm.add_parameter(
      "Steps between rebalances", law.rebalance_every,
      "Steps between two looks at which rank computes which RVE, on several MPI ranks; 0 = never. "
      "The results do not depend on it. Units: 1.",
      Patterns::Integer(0, 1000000));
  prm.leave_subsection();
  law.skipping.declare(prm);
  tissue.declare(prm, with_size_and_body_force);
  rve.add_parameters(prm);
}

void TissueRunSettings::check(const RveParameters &rve, const double sampled) const {
  tissue.check();
  law.skipping.check(rve);
  check_tissue_size(tissue, state_size(rve), sampled);
}
}  // namespace turgor
