// The sums over a body's neighbours in single precision, as conjugate gradients ask for them some fifty times
// a solution: two neighbours in eight lanes, or one whose row is needed twice, and several sums at a time, so
// that none waits for the one before. What a neighbour costs: doc/performance.md, "Stokes SPH".
//
//   FloatRow pull = drag_lanes::drawn(p, other + first, weight + first, count, p[i]);
#pragma once

#include "micro/solve/eight_floats.h"

#include <cstdint>
#include <cstring>

namespace turgor::drag_lanes {
using eight_floats::beside;

inline FloatRow halves_added(const EightFloats a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3) + __builtin_shufflevector(a, a, 4, 5, 6, 7);
}
inline EightFloats twice(const FloatRow &a) {
#if defined(__AVX__)
  return EightFloats(_mm256_broadcast_ps(reinterpret_cast<const __m128 *>(&a)));  // one load, no shuffle
#else
  return beside(a, a);
#endif
}
/// Two rows that lie one behind the other.
inline EightFloats two_at(const FloatRow *a) {
  EightFloats both;
  std::memcpy(&both, a, sizeof(both));
  return both;
}
/// w[0] and w[1], four times each
inline EightFloats of_two(const float *w) {
  using FourPairs = double __attribute__((vector_size(32)));
  double both;
  std::memcpy(&both, w, sizeof(both));
  const EightFloats a = EightFloats(FourPairs{both, both, both, both});
  return __builtin_shufflevector(a, a, 0, 0, 0, 0, 5, 5, 5, 5);
}
// numbers of a row, four times each
inline EightFloats first_two(const EightFloats a) {
  return __builtin_shufflevector(a, a, 0, 0, 0, 0, 5, 5, 5, 5);
}
inline EightFloats last_two(const EightFloats a) {
  return __builtin_shufflevector(a, a, 2, 2, 2, 2, 7, 7, 7, 7);
}

/// sum of w (p_j - me)
inline FloatRow drawn(const FloatRow *p, const std::uint16_t *other, const float *w, const std::uint32_t n,
                      const FloatRow me) {
  const EightFloats own = twice(me);
  EightFloats sum[2]{};
  std::uint32_t k = 0;
  for (; k + 4 <= n; k += 4)
    for (int part = 0; part < 2; ++part) {
      const std::uint32_t at = k + 2 * std::uint32_t(part);
      sum[part] += of_two(w + at) * (beside(p[other[at]], p[other[at + 1]]) - own);
    }
  FloatRow rest{};
  for (; k < n; ++k) rest += w[k] * (p[other[k]] - me);
  return halves_added(sum[0] + sum[1]) + rest;
}

/// sum of c (c . (p_j - me)); the fourth numbers of c are 0
inline FloatRow drawn_along(const FloatRow *p, const std::uint16_t *other, const FloatRow *c,
                            const std::uint32_t n, const FloatRow me) {
  const EightFloats own = twice(me);
  EightFloats sum[2]{};
  const auto add = [&](EightFloats &to, const EightFloats along, const EightFloats at) {
    EightFloats d = along * (at - own);
    d += __builtin_shufflevector(d, d, 1, 0, 3, 2, 5, 4, 7, 6);
    d += __builtin_shufflevector(d, d, 2, 3, 0, 1, 6, 7, 4, 5);
    to += along * d;
  };
  std::uint32_t k = 0;
  for (; k + 4 <= n; k += 4)
    for (int part = 0; part < 2; ++part) {
      const std::uint32_t at = k + 2 * std::uint32_t(part);
      add(sum[part], two_at(c + at), beside(p[other[at]], p[other[at + 1]]));
    }
  for (; k < n; ++k) add(sum[0], beside(c[k], FloatRow{}), twice(p[other[k]]));
  return halves_added(sum[0] + sum[1]);
}

/// columns[a] = sum of (p_j - me) u_a, u = w r with w as its fourth number; returns sum of w (p_j - me).
template <int dim>
inline FloatRow moments(const FloatRow *p, const std::uint16_t *other, const FloatRow *u,
                        const std::uint32_t n, const FloatRow me, FloatRow *columns) {
  const EightFloats own = twice(me);
  EightFloats low[2]{}, high[2]{};
  const auto add = [&](const int to, const std::uint32_t k) {
    const EightFloats apart = twice(p[other[k]]) - own, by = twice(u[k]);
    low[to] += apart * first_two(by);
    high[to] += apart * last_two(by);
  };
  std::uint32_t k = 0;
  for (; k + 2 <= n; k += 2) {
    add(0, k);
    add(1, k + 1);
  }
  if (k < n) add(0, k);
  const EightFloats a = low[0] + low[1], b = high[0] + high[1];
  columns[0] = __builtin_shufflevector(a, a, 0, 1, 2, 3);
  columns[1] = __builtin_shufflevector(a, a, 4, 5, 6, 7);
  if constexpr (dim == 3) columns[2] = __builtin_shufflevector(b, b, 0, 1, 2, 3);
  return __builtin_shufflevector(b, b, 4, 5, 6, 7);
}

/// sum of T_j u; T: columns of a body, the fourth is 0 in 3D
template <int dim, class Columns>
inline FloatRow by_tensors(const Columns *T, const std::uint16_t *other, const FloatRow *u,
                           const std::uint32_t n) {
  EightFloats low[2]{}, high[2]{};
  const auto add = [&](const int to, const std::uint32_t k) {
    const Columns &at = T[other[k]];
    const EightFloats by = twice(u[k]);
    low[to] += two_at(&at[0]) * first_two(by);
    if constexpr (dim == 3) high[to] += two_at(&at[2]) * last_two(by);
  };
  std::uint32_t k = 0;
  for (; k + 2 <= n; k += 2) {
    add(0, k);
    add(1, k + 1);
  }
  if (k < n) add(0, k);
  return halves_added((low[0] + low[1]) + (high[0] + high[1]));
}
}  // namespace turgor::drag_lanes
