// Moves the start of every scene by round-off: x += 1e-15 u max|x|, u in [-1, 1] from the seed, the direction
// and the particle's number.
//
// Linked into every test program, and into turgor_disturbed, the program itself as golden tests run it.
// TURGOR_DISTURB=SEED (1, 2, ...) switches it on; without it, or with 0, nothing is done. tests/disturbed.py
// runs whole suites so.
#include "run/start_disturbance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {
std::uint64_t seed = 0;

/// In [-1, 1] (splitmix64).
double uniform(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return double(std::int64_t(z ^ (z >> 31))) * 0x1p-63;
}

void disturb(const unsigned int direction, std::vector<double> &x) {
  double largest = 0.;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += 1e-15 * largest * uniform((seed << 40) + (std::uint64_t(direction) << 36) + i);
}

const bool switched_on = [] {
  const char *wish = std::getenv("TURGOR_DISTURB");
  seed = wish != nullptr ? std::strtoull(wish, nullptr, 10) : 0;
  if (seed > 0) turgor::disturb_start = disturb;
  return seed > 0;
}();
}  // namespace
