// The cells that scenes of SPH tissue start from, annealed with progress shown.
#pragma once

#include "micro/cells/tissue_structure.h"
#include "micro/processes/annealed_cells.h"

namespace turgor {
class RunContext;

/// Throws RunStopped: there is nothing to save yet, a resumed run anneals again.
ReferenceCell anneal_reference(RunContext &context, const ParenchymaParameters &cell,
                               const SphParameters &sph);

/// What the cells of a block (structured_block.h) hold: where they are all alike one is annealed, in its own
/// lattice, and copied; else each for itself. Throws RunStopped.
AnnealedCells anneal_block(RunContext &context, const TissueStructure &structure,
                           const ParenchymaParameters &cell, const SphParameters &sph,
                           const CellLayout &turgid);
}  // namespace turgor
