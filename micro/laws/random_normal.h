// Counter-based Gaussian random numbers, mean 0 and variance 1 (Box-Muller): three a call, a function of
// (seed, who, when) alone. Same bits on any number of threads, in any order and after a resumed run.
//
// In: seed of the run with the purpose mixed in, who (the cell's number), when (the step's).
#pragma once

#include "micro/laws/counter_random.h"

#include <array>
#include <cmath>
#include <numbers>

namespace turgor {
inline std::array<double, 3> random_normals(const std::uint64_t seed, const std::uint64_t who,
                                            const std::uint64_t when) {
  const std::uint64_t stream = mix_bits(mix_bits(seed) ^ who);
  double u[4];
  for (int k = 0; k < 4; ++k) u[k] = random_uniform(stream, 4 * when + std::uint64_t(k));
  const double a = std::sqrt(-2. * std::log1p(-u[0])), b = std::sqrt(-2. * std::log1p(-u[1]));
  constexpr double turn = 2. * std::numbers::pi;
  return {a * std::cos(turn * u[2]), a * std::sin(turn * u[2]), b * std::cos(turn * u[3])};
}
}  // namespace turgor
