// What holds the boundary of the piece of tissue of an RVE: its images, or another rule for the whole cells
// it is made of (a window cut along walls, mean_traction.h).
#pragma once

#include "run/choice.h"

namespace turgor {
enum class RveBoundary {
  periodic,
  linear_displacement,  ///< wall nodes at the boundary follow F: an upper bound of the energy
  uniform_traction      ///< the boundary is pulled by one stress: a lower bound
};
constexpr const char *words_of(RveBoundary) { return "periodic|linear_displacement|uniform_traction"; }
}  // namespace turgor
