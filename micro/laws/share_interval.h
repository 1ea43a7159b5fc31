// The interval in which a share lies that was found by counting, at 95 % (E. B. Wilson, J. Am. Stat. Assoc.
// 22:209, 1927, doi:10.1080/01621459.1927.10502953): with p = hits/n and z = 1.96,
//
//   (p + z^2/(2 n) -+ z sqrt(p (1 - p)/n + z^2/(4 n^2)))/(1 + z^2/n)
//
// It stays within 0 and 1 and is wide where there are few cases, also where all of them hit.
//
//   wilson_interval(60, 100)   0.502, 0.691
#pragma once

#include <cmath>
#include <cstdint>

namespace turgor {
struct ShareInterval {
  double low, high;
};

/// n > 0.
inline ShareInterval wilson_interval(const std::uint64_t hits, const std::uint64_t n) {
  constexpr double z = 1.959963984540054;  // of the normal distribution, 2.5 % beyond it
  const double count = double(n), p = double(hits) / count, narrower = 1. + z * z / count,
               middle = (p + z * z / (2. * count)) / narrower,
               half = z * std::sqrt(p * (1. - p) / count + z * z / (4. * count * count)) / narrower;
  return {std::fmax(0., middle - half), std::fmin(1., middle + half)};
}
}  // namespace turgor
