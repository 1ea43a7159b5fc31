// The reference cell that scenes of SPH tissue start from, annealed with progress shown.
#pragma once

#include "micro/processes/annealed_cells.h"

namespace turgor {
class RunContext;

/// Throws RunStopped: there is nothing to save yet, a resumed run anneals again.
ReferenceCell anneal_reference(RunContext &context, const ParenchymaParameters &cell,
                               const SphParameters &sph);
}  // namespace turgor
