// Differences between cells (thesis C.2.1, C.2.2, C.5): a parameter of a cell is drawn from a Gaussian about
// its mean and clamped at four standard deviations, so that with a spread of 10 % none is negative.
//
// The value is a function of (seed, id of the cell, which parameter) alone: no order, no storage, the same
// for a resumed run.
//
// In: mean (any unit), spread: standard deviation over the mean. Out: value (unit of the mean).
#pragma once

#include "micro/laws/random_normal.h"

#include <algorithm>
#include <cstdint>

namespace turgor {
enum class Varied : std::uint64_t { cycle_time, modulus, bulk_modulus, lysis_time, necrosis_pressure };

struct CellVariability {
  double spread = 0.1;  ///< no unit
  double clamp = 4.;    ///< standard deviations
  std::uint64_t seed = 1;

  double operator()(const double mean, const std::uint64_t id, const Varied which) const {
    if (spread == 0.) return mean;
    const double xi = random_normals(seed ^ 0x64696666657265ull, id, std::uint64_t(which))[0];
    return mean * (1. + spread * std::clamp(xi, -clamp, clamp));
  }
};
}  // namespace turgor
