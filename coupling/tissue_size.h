// Is a tissue of RVEs too large for this machine? Told from its input, before anything is built.
#pragma once

#include "macro/tissue_parameters.h"
#include "rve/rve.h"

#include <cstddef>

namespace turgor {
/// Bytes, of all ranks together: what a point was measured to need besides its states (linear elements), and
/// the RVEs' states, committed and trial, of state_size numbers each (make_rve.h). sampled: points at which
/// the displacement is watched.
double tissue_memory(const TissueParameters<2> &tissue, std::size_t state_size, double sampled = 0.);

/// Throws InputError with both numbers when the tissue needs more than this machine has.
void check_tissue_size(const TissueParameters<2> &tissue, std::size_t state_size, double sampled = 0.);
}  // namespace turgor
