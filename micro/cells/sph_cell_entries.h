// The entries of a cell filled with SPH fluid, subsections "Cell" and "SPH", and what their patterns
// cannot say.
#pragma once

#include "micro/cells/sph_parenchyma.h"

namespace turgor {
/// Declares both subsections in the current subsection of prm.
void declare_sph_cell(InputEntries &prm, ParenchymaParameters &cell, SphParameters &sph);

/// Throws std::invalid_argument, entry and allowed range in one sentence.
void check_sph_cell(const ParenchymaParameters &cell, const SphParameters &sph);
}  // namespace turgor
