// Time in which a freely growing population doubles (s), from the mean cycle time T (s) of its cells and its
// spread s (standard deviation over the mean): cells whose cycle times are Gaussian, T (1 + s xi), grow as N
// ~ exp(Lambda t) with 2 <exp(-Lambda T_i)> = 1, so Lambda T = (1 - sqrt(1 - 2 s^2 ln 2))/s^2; ln 2 for s =
// 0.
#pragma once

#include <cmath>
#include <numbers>

namespace turgor {
inline double doubling_time(const double T, const double spread) {
  const double s2 = spread * spread;
  const double growth = s2 > 0. ? (1. - std::sqrt(1. - 2. * s2 * std::numbers::ln2)) / s2 : std::numbers::ln2;
  return T * std::numbers::ln2 / growth;
}

inline double expected_cells(const double t, const double T, const double spread) {
  double sum = 1., twice = 1.;
  for (int k = 1; k * T * (1. - 5. * spread / std::sqrt(double(k))) <= t; ++k, twice *= 2.) {
    const double late = t - k * T;
    sum += twice * (spread > 0. ? 0.5 * std::erfc(-late / (std::sqrt(2. * k) * spread * T))
                                : double(late >= -1e-9 * T));
  }
  return sum;
}
}  // namespace turgor
