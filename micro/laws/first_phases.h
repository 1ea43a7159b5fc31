// Where in their cycle the first cells of a population are: all newborn, or with the ages of a population
// that has grown exponentially for long, of density 2 ln 2 2^-a over the phases a of [0, 1).
//
//   phase_at_start(FirstPhases::spread, seed, i)        of cell i, a function of both alone
#pragma once

#include "micro/laws/counter_random.h"

#include <cmath>

namespace turgor {
enum class FirstPhases {
  synchronous,  ///< all newborn
  spread        ///< ages of exponential growth
};
constexpr const char *words_of(FirstPhases) { return "synchronous|spread"; }

inline double phase_at_start(const FirstPhases phases, const std::uint64_t seed, const std::uint64_t i) {
  if (phases == FirstPhases::synchronous) return 0.;
  return -std::log2(1. - 0.5 * random_uniform(mix_bits(seed ^ 0x7068617365ull), i));
}
}  // namespace turgor
