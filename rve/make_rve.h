// From the user's entries to an RVE.
#pragma once

#include "rve/rve.h"
#include "rve/rve_parameters.h"

#include <memory>

namespace turgor {
/// Throws InputError with the entry and what is allowed.
std::unique_ptr<Rve<2>> make_rve(const RveParameters &parameters);

/// Numbers in a state of such an RVE (unknowns and history), for checks: none is built. Cells are laid at
/// most, where only that tells how many nodes they have; whether they come to rest at turgor the run finds
/// out. Throws InputError for entries that are wrong.
std::size_t state_size(const RveParameters &parameters);
}  // namespace turgor
