// A round cell comes to rest at turgor: from the stress-free state of make_round_cell.
//
//   Settle steps   the fluid alone, in the wall that is held
//   Anneal steps   osmosis (Eq. 3.2) and damped motion, as in thesis 3.3.1
//   Rest steps     where an unbalanced force above Rest residual is left: osmosis and descent of the energy
//                  (descent.h) until it is below, so that no count of steps decides whether a cell is at
//                  rest; at most that many
//
// Residual: largest unbalanced force over (turgor, at least 1 % of G t0/R) times the wall's area per node.
#pragma once

#include "micro/cells/round_cell.h"

#include <functional>

namespace turgor {
/// The fluid alone comes to rest in the wall that is held: Cell/Settle steps of damped motion, at first with
/// an ordering pressure as large as K, so that the particles stand as evenly as the wall lets them. Steps are
/// the fluid's, several times as long as with the wall free.
template <int dim>
void settle_fluid(RoundCell<dim> &cell, const std::function<void(unsigned int, unsigned int, double)> &watch);

/// All three. watch(step, steps, dt) after every step but those of settle_fluid (steps grows with Rest
/// steps); it may throw to stop. Returns the residual. Throws std::runtime_error where the cell diverges or
/// has not come to rest.
template <int dim>
double bring_to_turgor(RoundCell<dim> &cell,
                       const std::function<void(unsigned int, unsigned int, double)> &watch);
}  // namespace turgor
