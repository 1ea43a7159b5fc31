// Whether the walls of a tissue soften when they are stretched (thesis Eq. 3.8, wall_yield.h), and how they
// come back.
#pragma once

namespace turgor {
enum class Yielding {
  none,
  reversible,  ///< along the same curve
  plastic      ///< elastic: a stretch stays
};
constexpr const char *words_of(Yielding) { return "none|reversible|plastic"; }
}  // namespace turgor
