// Is a tissue of RVEs too large for this machine? Told from its input, before anything is built.
#pragma once

#include "macro/tissue_parameters.h"
#include "rve/rve.h"

namespace turgor
{
/// Bytes, of all ranks together: what a point was measured to need besides its states (linear elements), and the RVEs' states,
/// committed and trial. sampled: points at which the displacement is watched.
double tissue_memory(const TissueParameters<2> &tissue, const Rve<2> &rve, double sampled = 0.);

/// Throws InputError with both numbers when the tissue needs more than this machine has.
void check_tissue_size(const TissueParameters<2> &tissue, const Rve<2> &rve, double sampled = 0.);
} // namespace turgor
