// The Structure/Gap that opens air spaces of a wanted share of the undeformed tissue's area: looked for by
// halving, as that share follows from the equilibrium of the whole patch at turgor. It rises with the gap, in
// steps where walls of few nodes or of many lengths lose a tie.
//
//   const GapForAir found = gap_for_air(rve, 0.06, [](double) {});   rve.structure.gap = found.gap;
#pragma once

#include "rve/rve_parameters.h"

#include <functional>

namespace turgor {
struct GapForAir {
  double gap, share;  ///< m; of the area, that this gap opens
};

/// rve: hydrostatic and periodic; its gap counts for nothing. wanted: of the area, above 0. progress: told
/// how much of the search is done. About ten RVEs are brought to rest. Throws RunFailed where the largest gap
/// opens less than wanted.
GapForAir gap_for_air(RveParameters rve, double wanted, const std::function<void(double)> &progress);
}  // namespace turgor
