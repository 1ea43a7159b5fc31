// From the user's entries to an RVE.
#pragma once

#include "rve/rve.h"
#include "rve/rve_parameters.h"

#include <memory>

namespace turgor
{
/// Throws InputError with the entry and what is allowed.
std::unique_ptr<Rve<2>> make_rve(const RveParameters &parameters);
} // namespace turgor
