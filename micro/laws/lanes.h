// A number, or four of them side by side: what a law needs beyond the operators, so that one body serves both
// with the same bits.
#pragma once

#include <cmath>
#include <cstddef>

namespace turgor::lanes {
using Four = double __attribute__((vector_size(32)));
using FourYes = decltype(Four() < Four());  ///< all bits or none

inline double root(const double a) { return std::sqrt(a); }
inline Four root(const Four a) {
  Four result{};
  for (std::size_t k = 0; k < 4; ++k) result[k] = std::sqrt(a[k]);
  return result;
}

inline double cube_root(const double a) { return std::cbrt(a); }
inline Four cube_root(const Four a) {
  Four result{};
  for (std::size_t k = 0; k < 4; ++k) result[k] = std::cbrt(a[k]);
  return result;
}

inline double where(const bool yes, const double a, const double b) { return yes ? a : b; }
inline Four where(const FourYes yes, const Four a, const Four b) {
  return Four((FourYes(a) & yes) | (FourYes(b) & ~yes));
}

inline bool no(const bool yes) { return !yes; }
inline FourYes no(const FourYes yes) { return ~yes; }

inline bool any(const bool yes) { return yes; }
inline bool any(const FourYes yes) { return ((yes[0] | yes[1]) | (yes[2] | yes[3])) != 0; }
}  // namespace turgor::lanes
