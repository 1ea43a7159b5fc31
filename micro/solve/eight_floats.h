// Vectors of cells in single precision, eight cells at a time: by components (one register each) and as rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace turgor {
using EightFloats = float __attribute__((vector_size(32)));

/// A vector of each of eight cells.
struct Eight {
  EightFloats x{}, y{}, z{};
};

/// A vector of one cell, the fourth number is 0.
using FloatRow = float __attribute__((vector_size(16)));

namespace eight_floats {
/// Rows a and b side by side.
inline EightFloats beside(const FloatRow a, const FloatRow b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

// In each half of the lanes: numbers of a and b in turn, and pairs of them.
inline EightFloats woven_low(const EightFloats a, const EightFloats b) {
  return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
}
inline EightFloats woven_high(const EightFloats a, const EightFloats b) {
  return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
}
inline EightFloats pairs_low(const EightFloats a, const EightFloats b) {
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
inline EightFloats pairs_high(const EightFloats a, const EightFloats b) {
  return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// Rows a[0..7] given as row(k), by components; the fourth apart.
template <class GiveRow>
inline Eight columns(const GiveRow &row, EightFloats &fourth) {
  const EightFloats a = beside(row(0), row(4)), b = beside(row(1), row(5)), c = beside(row(2), row(6)),
                    d = beside(row(3), row(7));
  const EightFloats ab = woven_low(a, b), cd = woven_low(c, d), ab_z = woven_high(a, b),
                    cd_z = woven_high(c, d);
  fourth = pairs_high(ab_z, cd_z);
  return {pairs_low(ab, cd), pairs_high(ab, cd), pairs_low(ab_z, cd_z)};
}
template <class GiveRow>
inline Eight columns(const GiveRow &row) {
  EightFloats none;
  return columns(row, none);
}

/// The other way, to rows[0..7].
inline void to_rows(const Eight &v, FloatRow *rows) {
  const EightFloats none{};
  const EightFloats xy = woven_low(v.x, v.y), z0 = woven_low(v.z, none), xy_2 = woven_high(v.x, v.y),
                    z0_2 = woven_high(v.z, none);
  const EightFloats two[4] = {pairs_low(xy, z0), pairs_high(xy, z0), pairs_low(xy_2, z0_2),
                              pairs_high(xy_2, z0_2)};
  for (int k = 0; k < 4; ++k) {
    rows[k] = __builtin_shufflevector(two[k], two[k], 0, 1, 2, 3);
    rows[k + 4] = __builtin_shufflevector(two[k], two[k], 4, 5, 6, 7);
  }
}

/// to[0 .. count - 1] += the first of the eight rows; count <= 8.
inline void add_rows(const Eight &v, const std::size_t count, FloatRow *to) {
  FloatRow rows[8];
  to_rows(v, rows);
  for (std::size_t lane = 0; lane < count; ++lane) to[lane] += rows[lane];
}

using FourDoubles = double __attribute__((vector_size(32)));

#if defined(__AVX__)
// GCC's own conversions of vectors go half by half through memory; these are one instruction.
inline FourDoubles doubles(const FloatRow a) { return FourDoubles(_mm256_cvtps_pd(__m128(a))); }
inline FloatRow floats(const FourDoubles a) { return FloatRow(_mm256_cvtpd_ps(__m256d(a))); }
#else
inline FourDoubles doubles(const FloatRow a) { return __builtin_convertvector(a, FourDoubles); }
inline FloatRow floats(const FourDoubles a) { return __builtin_convertvector(a, FloatRow); }
#endif

/// Lanes 0 to 3 or 4 to 7 as doubles, and back.
template <bool high>
inline FourDoubles half(const EightFloats a) {
  if constexpr (high)
    return doubles(__builtin_shufflevector(a, a, 4, 5, 6, 7));
  else
    return doubles(__builtin_shufflevector(a, a, 0, 1, 2, 3));
}
inline EightFloats halves(const FourDoubles low, const FourDoubles high) {
  return beside(floats(low), floats(high));
}

/// Lanes added in pairs, as doubles.
inline FourDoubles wide(const EightFloats a) { return half<false>(a) + half<true>(a); }

inline double sum(const FourDoubles a) { return (a[0] + a[1]) + (a[2] + a[3]); }

inline EightFloats dot(const Eight &a, const Eight &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
}  // namespace eight_floats
}  // namespace turgor
