// Counter-based random numbers: the value depends on (seed, counter) alone, so results do
// not depend on threads, order or restarts. SplitMix64 finaliser (Steele et al. 2014,
// 10.1145/2660193.2660195) over the pair.
#pragma once

#include <cstdint>

namespace turgor {
inline std::uint64_t mix_bits(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// Uniform in [0, 1).
inline double random_uniform(const std::uint64_t seed, const std::uint64_t counter) {
  return double(mix_bits(mix_bits(seed) ^ counter) >> 11) * 0x1.0p-53;
}
}  // namespace turgor
