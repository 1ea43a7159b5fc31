// Which of many points are near a place, eight at a time: what neighbour lists spend their time with.
//
// In: coordinates (m), each direction on its own. Sums run over the directions in order, as a loop over one point would have them, so
// that a list does not depend on how many points are looked at together.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace turgor
{
/// Points looked at together; arrays have so many numbers behind the last point that may be read.
constexpr std::uint32_t near_block = 8;

/// Bit l is set if point k + l is nearer to `at` than the root of limit2 (m^2): of all points, or of each, limit2[k + l].
template <int dim, typename Limit>
inline unsigned int near_bits(const std::array<const double *, dim> &x, const std::uint32_t k, const double *const at, const Limit limit2)
{
  typedef double Four __attribute__((vector_size(32)));
  unsigned int bits = 0;
  for (std::uint32_t half = 0; half < near_block; half += 4)
    {
      const auto four = [&](const double *const p) {
        Four values;
        __builtin_memcpy(&values, p + k + half, sizeof values);
        return values;
      };
      Four r2;
      for (int d = 0; d < dim; ++d)
        {
          const Four away = four(x[d]) - at[d];
          r2 = d == 0 ? away * away : r2 + away * away;
        }
      Four limit;
      if constexpr (std::is_pointer_v<Limit>)
        limit = four(limit2);
      else
        limit = Four{limit2, limit2, limit2, limit2};
#if defined(__AVX2__)
      bits |= unsigned(_mm256_movemask_pd(_mm256_cmp_pd(r2, limit, _CMP_LT_OQ))) << half;
#else
      for (unsigned int l = 0; l < 4; ++l)
        bits |= unsigned(r2[l] < limit[l]) << (half + l);
#endif
    }
  return bits;
}

/// The numbers of from[0 .. 8) whose bit is set, in order, to `to`, of which eight are written. How many they are.
inline unsigned int keep_numbers(const std::uint16_t *const from, const unsigned int bits, std::uint16_t *const to)
{
#if defined(__AVX2__)
  static constexpr auto places = [] { // of the bytes of the numbers kept
    std::array<std::array<std::uint8_t, 16>, 256> table{};
    for (unsigned int b = 0; b < 256; ++b)
      for (unsigned int l = 0, kept = 0; l < 8; ++l)
        if (b >> l & 1)
          {
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
  for (unsigned int left = bits; left != 0; left &= left - 1)
    to[kept++] = from[std::countr_zero(left)];
  return kept;
#endif
}
} // namespace turgor
