// What a run of parenchyma cells says about entries that are defined but hardly meant.
//
//   remark_on_walls(context, cell);
#pragma once

#include "micro/cells/parenchyma_parameters.h"

namespace turgor {
class RunContext;

/// Where turgor stretches walls far beyond what walls of cells bear: a remark, "wall_stretch" in the notes.
/// No mistake: laws of such walls are defined, and studies go there.
void remark_on_walls(RunContext &context, const ParenchymaParameters &cell);
}  // namespace turgor
