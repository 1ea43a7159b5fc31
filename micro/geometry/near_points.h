// Which of many points are near a place, eight at a time: what neighbour lists spend their time with.
//
// In: coordinates (m), each direction on its own. Sums run over the directions in order, as a loop over one
// point would have them, so that a list does not depend on how many points are looked at together.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace turgor {
/// Points looked at together; arrays have so many numbers behind the last point that may be read.
constexpr std::uint32_t near_block = 8;

typedef double FourNumbers __attribute__((vector_size(32)));

inline FourNumbers four_numbers(const double *const p) {
  FourNumbers values;
  __builtin_memcpy(&values, p, sizeof values);
  return values;
}

/// Bit l is set if point k + l is nearer to `at` than the root of a limit (m^2): limit2(j) has those of
/// points j to j + 3.
template <int dim, typename Limit>
inline unsigned int near_bits(const std::array<const double *, dim> &x, const std::uint32_t k,
                              const double *const at, const Limit &limit2) {
  unsigned int bits = 0;
  for (std::uint32_t half = 0; half < near_block; half += 4) {
    FourNumbers r2{};
    for (int d = 0; d < dim; ++d) {
      const FourNumbers away = four_numbers(x[d] + k + half) - at[d];
      r2 = d == 0 ? away * away : r2 + away * away;
    }
    const FourNumbers limit = limit2(k + half);
#if defined(__AVX2__)
    bits |= unsigned(_mm256_movemask_pd(_mm256_cmp_pd(r2, limit, _CMP_LT_OQ))) << half;
#else
    for (unsigned int l = 0; l < 4; ++l) bits |= unsigned(r2[l] < limit[l]) << (half + l);
#endif
  }
  return bits;
}

/// Bit l is set for the first `live` of a block.
inline unsigned int first_bits(const std::uint32_t live) {
  return live < near_block ? (1u << live) - 1 : (1u << near_block) - 1;
}

/// Bit l is set if numbers[l] > than; of eight numbers below 2^31.
inline unsigned int greater_bits(const std::uint32_t *const numbers, const std::uint32_t than) {
#if defined(__AVX2__)
  const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i *>(numbers));
  return unsigned(
      _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpgt_epi32(all, _mm256_set1_epi32(int(than))))));
#else
  unsigned int bits = 0;
  for (unsigned int l = 0; l < near_block; ++l) bits |= unsigned(numbers[l] > than) << l;
  return bits;
#endif
}

/// The numbers of from[0 .. 8) whose bit is set, in order, to `to`, of which eight are written. How many they
/// are.
inline unsigned int keep_numbers(const std::uint16_t *const from, const unsigned int bits,
                                 std::uint16_t *const to) {
#if defined(__AVX2__)
  static constexpr auto places = [] {  // of the bytes of the numbers kept
    std::array<std::array<std::uint8_t, 16>, 256> table{};
    for (unsigned int b = 0; b < 256; ++b)
      for (unsigned int l = 0, kept = 0; l < 8; ++l)
        if (b >> l & 1) {
          table[b][2 * kept] = std::uint8_t(2 * l);
          table[b][2 * kept + 1] = std::uint8_t(2 * l + 1);
          ++kept;
        }
    return table;
  }();
  const __m128i all = _mm_loadu_si128(reinterpret_cast<const __m128i *>(from)),
                order = _mm_loadu_si128(reinterpret_cast<const __m128i *>(places[bits].data()));
  _mm_storeu_si128(reinterpret_cast<__m128i *>(to), _mm_shuffle_epi8(all, order));
  return unsigned(std::popcount(bits));
#else
  unsigned int kept = 0;
  for (unsigned int left = bits; left != 0; left &= left - 1) to[kept++] = from[std::countr_zero(left)];
  return kept;
#endif
}

inline unsigned int keep_numbers(const std::uint32_t *const from, const unsigned int bits,
                                 std::uint32_t *const to) {
#if defined(__AVX2__)
  static constexpr auto places = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (unsigned int b = 0; b < 256; ++b)
      for (unsigned int l = 0, kept = 0; l < 8; ++l)
        if (b >> l & 1) table[b][kept++] = std::uint8_t(l);
    return table;
  }();
  const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i *>(from)),
                order = _mm256_cvtepu8_epi32(
                    _mm_loadl_epi64(reinterpret_cast<const __m128i *>(places[bits].data())));
  _mm256_storeu_si256(reinterpret_cast<__m256i *>(to), _mm256_permutevar8x32_epi32(all, order));
  return unsigned(std::popcount(bits));
#else
  unsigned int kept = 0;
  for (unsigned int left = bits; left != 0; left &= left - 1) to[kept++] = from[std::countr_zero(left)];
  return kept;
#endif
}

/// Sorts numbers that all differ, are below 2^31 and are few: up to sixteen by counting for each those that
/// are greater.
inline void sort_few(std::uint32_t *const numbers, const std::size_t count) {
  if (count > 2 * near_block) return std::sort(numbers, numbers + count);
  std::uint32_t all[2 * near_block] = {};  // zeros are greater than none
  std::copy_n(numbers, count, all);
  for (std::size_t k = 0; k < count; ++k) {
    int greater = std::popcount(greater_bits(all, all[k]));
    if (count > near_block) greater += std::popcount(greater_bits(all + near_block, all[k]));
    numbers[count - 1 - std::size_t(greater)] = all[k];
  }
}
}  // namespace turgor
