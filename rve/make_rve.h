// From the user's entries to an RVE.
#pragma once

#include "rve/rve.h"
#include "rve/rve_parameters.h"

#include <memory>

namespace turgor
{
/// Throws InputError with the entry and what is allowed.
std::unique_ptr<Rve<2>> make_rve(const RveParameters &parameters);

/// Numbers in a state of such an RVE (unknowns and history), for checks: particles, whose annealing takes seconds, are only counted; whether
/// they come to rest the run finds out. Throws InputError as make_rve().
std::size_t state_size(const RveParameters &parameters);
} // namespace turgor
