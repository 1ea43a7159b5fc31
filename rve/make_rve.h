// From the user's entries to an RVE.
#pragma once

#include "rve/rve.h"
#include "rve/rve_parameters.h"

#include <array>
#include <memory>

namespace turgor {
/// Throws InputError with the entry and what is allowed.
std::unique_ptr<Rve<2>> make_rve(const RveParameters &parameters);

/// m, mean length of a cell along x and y at F = I: Cell/Period of square cells; of others what the RVE's
/// period is over Columns, its area over that and Rows, or, where the tissue is turned, the root of a cell's
/// area both ways. A piece of tissue of n x m cells is n and m times as large.
std::array<double, 2> cell_size(const RveParameters &parameters, const Rve<2> &rve);

/// Numbers in a state of such an RVE (unknowns and history), for checks: none is built. Cells are laid at
/// most, where only that tells how many nodes they have; whether they come to rest at turgor the run finds
/// out. Throws InputError for entries that are wrong.
std::size_t state_size(const RveParameters &parameters);
}  // namespace turgor
