// Particles in an order in which near ones in space are near in memory: along a Morton curve (the bits of the
// three bin numbers interleaved). Ties keep their order, so the result depends on positions alone.
//
// In: positions (m), width of a bin (m). Out: where the particles go (rearrangement.h).
#pragma once

#include "micro/engine/particles.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace turgor {
inline Rearrangement space_order(const Particles<3> &particles, const double width) {
  const std::size_t n = particles.size();
  const auto spread = [](std::uint64_t v) {  // 21 bits, two zeros between any two
    v &= 0x1fffff;
    v = (v | v << 32) & 0x1f00000000ffffull;
    v = (v | v << 16) & 0x1f0000ff0000ffull;
    v = (v | v << 8) & 0x100f00f00f00f00full;
    v = (v | v << 4) & 0x10c30c30c30c30c3ull;
    return (v | v << 2) & 0x1249249249249249ull;
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(n);
  for (int d = 0; d < 3; ++d) {
    const auto &x = particles.x[d];
    const double low = n > 0 ? *std::min_element(x.begin(), x.end()) : 0.;
    for (std::size_t i = 0; i < n; ++i)
      keys[i].first |= spread(std::uint64_t(std::min((x[i] - low) / width, 2097151.))) << d;
  }
  for (std::size_t i = 0; i < n; ++i) keys[i].second = std::uint32_t(i);
  std::sort(keys.begin(), keys.end());
  Rearrangement places{std::vector<std::uint32_t>(n)};
  for (std::size_t k = 0; k < n; ++k) places.source[k] = keys[k].second;
  return places;
}
}  // namespace turgor
