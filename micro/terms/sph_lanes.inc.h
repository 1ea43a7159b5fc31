// The vector of doubles the sweeps compute with, 8 lanes with AVX-512, else 4: arithmetic beyond the
// operators, gathering of rows, angle. Included by sph_sweeps.inc.h alone and under its rule: anonymous
// namespace, no inline function of a shared header. A file that defines TURGOR_PORTABLE_LANES, or one for a
// processor without AVX2, gets the lanes in the compiler's own vectors, without intrinsics.
#pragma once

#include "micro/terms/sph_sweeps.h"

#if defined(TURGOR_PORTABLE_LANES)
#elif defined(__AVX512F__) && defined(__AVX512DQ__)
#define TURGOR_AVX512_LANES
#elif defined(__AVX2__)
#define TURGOR_AVX2_LANES
#endif

#if defined(TURGOR_AVX512_LANES) || defined(TURGOR_AVX2_LANES)
#include <immintrin.h>
#endif

namespace turgor::sph {
namespace {
#if defined(TURGOR_AVX512_LANES)
constexpr int W = 8;
using V = __m512d;
inline V splat(double a) { return _mm512_set1_pd(a); }
inline V load(const double *p) { return _mm512_loadu_pd(p); }
inline void store(double *p, V a) { _mm512_storeu_pd(p, a); }
inline V positive(V a) { return _mm512_max_pd(a, _mm512_setzero_pd()); }
inline V lesser(V a, V b) { return _mm512_min_pd(a, b); }
inline V greater(V a, V b) { return _mm512_max_pd(a, b); }
inline V root(V a) { return _mm512_sqrt_pd(a); }
inline bool any_less(V a, V b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ) != 0; }
inline V select_less(V a, V b, V yes, V no) {
  return _mm512_mask_blend_pd(_mm512_cmp_pd_mask(a, b, _CMP_LT_OQ), no, yes);
}
inline double sum(V a) { return _mm512_reduce_add_pd(a); }
/// 1/sqrt(a), a > 0: hardware estimate (14 bit) and two Newton steps (full precision).
inline V rsqrt(V a) {
  V y = _mm512_rsqrt14_pd(a);
  const V h = _mm512_mul_pd(a, splat(0.5));
  y = _mm512_mul_pd(y, _mm512_fnmadd_pd(_mm512_mul_pd(h, y), y, splat(1.5)));
  y = _mm512_mul_pd(y, _mm512_fnmadd_pd(_mm512_mul_pd(h, y), y, splat(1.5)));
  return y;
}
/// 1/a: hardware estimate and two Newton steps.
inline V reciprocal(V a) {
  V y = _mm512_rcp14_pd(a);
  y = _mm512_mul_pd(y, _mm512_fnmadd_pd(a, y, splat(2.)));
  return _mm512_mul_pd(y, _mm512_fnmadd_pd(a, y, splat(2.)));
}
/// Four columns of eight rows given as two halves of four rows each: lo[k], hi[k] are row k and row k + 4.
inline void transpose(const __m256d lo[4], const __m256d hi[4], V c[4]) {
  V r[4], t[4];
  for (int k = 0; k < 4; ++k) r[k] = _mm512_insertf64x4(_mm512_castpd256_pd512(lo[k]), hi[k], 1);
  for (int k = 0; k < 4; k += 2) {
    t[k] = _mm512_unpacklo_pd(r[k], r[k + 1]);
    t[k + 1] = _mm512_unpackhi_pd(r[k], r[k + 1]);
  }
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  c[0] = _mm512_permutex2var_pd(t[0], low, t[2]);
  c[1] = _mm512_permutex2var_pd(t[1], low, t[3]);
  c[2] = _mm512_permutex2var_pd(t[0], high, t[2]);
  c[3] = _mm512_permutex2var_pd(t[1], high, t[3]);
}
/// Columns 0 to 3 of the rows j[0..7], `stride` doubles apart.
template <unsigned int stride>
inline void load_half_rows(const double *rows, const std::uint16_t *j, V c[4]) {
  __m256d lo[4], hi[4];
  for (int k = 0; k < 4; ++k) {
    lo[k] = _mm256_load_pd(rows + std::uint32_t(j[k]) * stride);
    hi[k] = _mm256_load_pd(rows + std::uint32_t(j[k + 4]) * stride);
  }
  transpose(lo, hi, c);
}
/// The other way: give(k, four numbers of lane k), lanes in order.
template <typename Give>
inline void to_rows(const V c[4], const Give &give) {
  const V t0 = _mm512_unpacklo_pd(c[0], c[1]), t1 = _mm512_unpackhi_pd(c[0], c[1]),
          t2 = _mm512_unpacklo_pd(c[2], c[3]), t3 = _mm512_unpackhi_pd(c[2], c[3]);
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  // r[k] holds lanes k and k + 4
  const V r[4] = {_mm512_permutex2var_pd(t0, low, t2), _mm512_permutex2var_pd(t1, low, t3),
                  _mm512_permutex2var_pd(t0, high, t2), _mm512_permutex2var_pd(t1, high, t3)};
  for (int k = 0; k < 4; ++k) give(k, _mm512_castpd512_pd256(r[k]));
  for (int k = 0; k < 4; ++k) give(k + 4, _mm512_extractf64x4_pd(r[k], 1));
}
/// Columns 0 to 7 of the rows j[0..7], `stride` doubles apart: c[k] holds column k of the eight rows.
template <unsigned int stride = row_doubles>
inline void load_rows(const double *rows, const std::uint16_t *j, V c[8]) {
  V r[8];
  for (int k = 0; k < 8; ++k) r[k] = _mm512_load_pd(rows + std::uint32_t(j[k]) * stride);
  V t[8];
  for (int k = 0; k < 8; k += 2) {
    t[k] = _mm512_unpacklo_pd(r[k], r[k + 1]);
    t[k + 1] = _mm512_unpackhi_pd(r[k], r[k + 1]);
  }
  for (int k = 0; k < 2; ++k) {
    const V a = _mm512_shuffle_f64x2(t[k], t[k + 2], 0x88), b = _mm512_shuffle_f64x2(t[k], t[k + 2], 0xdd);
    const V e = _mm512_shuffle_f64x2(t[k + 4], t[k + 6], 0x88),
            g = _mm512_shuffle_f64x2(t[k + 4], t[k + 6], 0xdd);
    c[k] = _mm512_shuffle_f64x2(a, e, 0x88);
    c[k + 4] = _mm512_shuffle_f64x2(a, e, 0xdd);
    c[k + 2] = _mm512_shuffle_f64x2(b, g, 0x88);
    c[k + 6] = _mm512_shuffle_f64x2(b, g, 0xdd);
  }
}
#else
constexpr int W = 4;
typedef double V __attribute__((vector_size(32)));
inline V splat(double a) { return V{a, a, a, a}; }
inline V load(const double *p) {
  V a;
  __builtin_memcpy(&a, p, sizeof a);
  return a;
}
inline void store(double *p, V a) { __builtin_memcpy(p, &a, sizeof a); }
inline V select_less(V a, V b, V yes, V no) { return a < b ? yes : no; }
inline double sum(V a) { return (a[0] + a[1]) + (a[2] + a[3]); }
#if defined(TURGOR_AVX2_LANES)
inline V positive(V a) { return _mm256_max_pd(a, _mm256_setzero_pd()); }
inline V lesser(V a, V b) { return _mm256_min_pd(a, b); }
inline V greater(V a, V b) { return _mm256_max_pd(a, b); }
inline V root(V a) { return _mm256_sqrt_pd(a); }
inline bool any_less(V a, V b) { return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)) != 0; }
#else
inline V positive(V a) { return a > splat(0.) ? a : splat(0.); }
inline V lesser(V a, V b) { return a < b ? a : b; }
inline V greater(V a, V b) { return a < b ? b : a; }
inline V root(V a) {
  V y;
  for (int k = 0; k < W; ++k) y[k] = __builtin_sqrt(a[k]);
  return y;
}
inline bool any_less(V a, V b) { return a[0] < b[0] || a[1] < b[1] || a[2] < b[2] || a[3] < b[3]; }
#endif
inline V rsqrt(V a) { return splat(1.) / root(a); }
inline V reciprocal(V a) { return splat(1.) / a; }
inline void transpose(const V r[4], V c[4]) {
  const V lo0 = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6),
          hi0 = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
  const V lo1 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6),
          hi1 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
  c[0] = __builtin_shufflevector(lo0, lo1, 0, 1, 4, 5);
  c[1] = __builtin_shufflevector(hi0, hi1, 0, 1, 4, 5);
  c[2] = __builtin_shufflevector(lo0, lo1, 2, 3, 6, 7);
  c[3] = __builtin_shufflevector(hi0, hi1, 2, 3, 6, 7);
}
/// Columns 0 to 3 of the rows j[0..3], `stride` doubles apart.
template <unsigned int stride>
inline void load_half_rows(const double *rows, const std::uint16_t *j, V c[4]) {
  const auto row = [&](int k) { return load(rows + std::uint32_t(j[k]) * stride); };
  const V r[4] = {row(0), row(1), row(2), row(3)};
  transpose(r, c);
}
/// The other way: give(k, four numbers of lane k), lanes in order.
template <typename Give>
inline void to_rows(const V c[4], const Give &give) {
  V r[4];
  transpose(c, r);
  for (int k = 0; k < 4; ++k) give(k, r[k]);
}
template <unsigned int stride = row_doubles>
inline void load_rows(const double *rows, const std::uint16_t *j, V c[8]) {
  load_half_rows<stride>(rows, j, c);
  load_half_rows<stride>(rows + 4, j, c + 4);
}
#endif

/// Columns 0 and 1 of the rows j[0..W-1], `stride` doubles apart.
template <unsigned int stride>
inline void load_two_columns(const double *rows, const std::uint16_t *j, V c[2]) {
#if defined(TURGOR_AVX2_LANES)
  const auto row = [&](int k) { return rows + std::uint32_t(j[k]) * stride; };
  const V even = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(row(0))), _mm_load_pd(row(2)), 1),
          odd = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(row(1))), _mm_load_pd(row(3)), 1);
  c[0] = _mm256_unpacklo_pd(even, odd);
  c[1] = _mm256_unpackhi_pd(even, odd);
#else
  V all[4];
  load_half_rows<stride>(rows, j, all);
  c[0] = all[0];
  c[1] = all[1];
#endif
}
/// to[d] = the sum of a[d], each as sum() has it.
template <int n>
inline void sums(const V a[n], double to[n]) {
#if defined(TURGOR_AVX2_LANES)
  for (int d = 0; d < n; d += 2) {
    const V pairs = _mm256_hadd_pd(a[d], a[d + 1 < n ? d + 1 : d]);
    const __m128d both = _mm_add_pd(_mm256_castpd256_pd128(pairs), _mm256_extractf128_pd(pairs, 1));
    to[d] = both[0];
    if (d + 1 < n) to[d + 1] = both[1];
  }
#else
  for (int d = 0; d < n; ++d) to[d] = sum(a[d]);
#endif
}

/// to[k] = the sum of a[k], eight at once.
inline void sums_of_eight(const V a[8], double to[8]) {
#if defined(TURGOR_AVX512_LANES)
  V pairs[4], halves[2];
  for (int k = 0; k < 4; ++k)
    pairs[k] = _mm512_unpacklo_pd(a[2 * k], a[2 * k + 1]) + _mm512_unpackhi_pd(a[2 * k], a[2 * k + 1]);
  for (int k = 0; k < 2; ++k)
    halves[k] = _mm512_shuffle_f64x2(pairs[2 * k], pairs[2 * k + 1], 0x88) +
                _mm512_shuffle_f64x2(pairs[2 * k], pairs[2 * k + 1], 0xdd);
  store(to,
        _mm512_shuffle_f64x2(halves[0], halves[1], 0x88) + _mm512_shuffle_f64x2(halves[0], halves[1], 0xdd));
#else
  sums<8>(a, to);
#endif
}

/// Four doubles side by side: a row, or half of one.
typedef double Row __attribute__((vector_size(32)));
inline Row load_row(const double *p) {
  Row a;
  __builtin_memcpy(&a, p, sizeof a);
  return a;
}
inline void store_row(double *p, Row a) { __builtin_memcpy(p, &a, sizeof a); }
inline Row splat_row(double a) { return Row{a, a, a, a}; }
/// Lane k of the four columns is added to row j[k], `stride` doubles apart; lanes in order.
template <unsigned int stride = 4>
inline void add_to_rows(double *rows, const std::uint16_t *j, const V c[4]) {
  to_rows(c, [&](const int k, const Row add) {
    double *row = rows + std::uint32_t(j[k]) * stride;
    store_row(row, load_row(row) + add);
  });
}
/// 1 in the first `live` lanes, else 0.
inline V first_lanes(const std::uint32_t live) {
  alignas(64) static constexpr double ones[2 * 8] = {1., 1., 1., 1., 1., 1., 1., 1.};
  return load(ones + 8 - (live < W ? live : W));
}

constexpr double pi = 3.14159265358979323846;

/// atan2(s, c) lane by lane (Cephes rational approximation, 2e-16).
inline V angle(V s, V c) {
  const V zero = splat(0.), as = select_less(s, zero, -s, s), ac = select_less(c, zero, -c, c);
  const V big = select_less(as, ac, ac, as), small = select_less(as, ac, as, ac);
  const V wide = big * splat(0.41421356237309503);  // tan(pi/8) < small/big: reduce by pi/4
  const V t = select_less(wide, small, small - big, small) *
              reciprocal(select_less(wide, small, small + big, big) + splat(1e-290));
  const V z = t * t;
  const V p = ((((splat(-8.750608600031904122785E-1) * z + splat(-1.615753718733365076637E1)) * z +
                 splat(-7.500855792314704667340E1)) *
                    z +
                splat(-1.228866684490136173410E2)) *
                   z +
               splat(-6.485021904942025371773E1)) *
              z;
  const V d = ((((z + splat(2.485846490142306297962E1)) * z + splat(1.650270098316988542046E2)) * z +
                splat(4.328810604912902668951E2)) *
                   z +
               splat(4.853903996359136964868E2)) *
                  z +
              splat(1.945506571482613964425E2);
  V a = t + t * (p * reciprocal(d));
  a = select_less(wide, small, a + splat(pi / 4), a);
  a = select_less(as, ac, a, splat(pi / 2) - a);
  a = select_less(c, zero, splat(pi) - a, a);
  return select_less(s, zero, -a, a);
}
}  // namespace
}  // namespace turgor::sph
