// Gauss points of a face and what the wall's integrands are there (sph_wall_triangles.inc.h has the
// equations; it alone includes this). Quadratures of 6 (degree 4), 3 (degree 2) and 1 points: Dunavant
// 1985, 10.1002/nme.1620210612.
#pragma once

#include "micro/terms/sph_pairs.inc.h"

namespace turgor::sph {
namespace {
/// Three Gauss points that are alike: (alpha, beta, beta) and its turns, beta = (1 - alpha)/2, each of weight
/// w. From the centroid they are the corners times delta = alpha - beta. (The centroid itself counts as the
/// first of three.)
struct Orbit {
  double w, alpha;
  constexpr double beta() const { return 0.5 * (1. - alpha); }
  constexpr double delta() const { return 1.5 * alpha - 0.5; }
};
constexpr Orbit orbits[quadratures][2] = {
    {{0.22338158967801147, 0.10810301816807023}, {0.10995174365532187, 0.81684757298045851}},
    {{1. / 3., 2. / 3.}, {}},
    {{1., 1. / 3.}, {}}};
/// Weight of corner k in point g.
constexpr double share_of(const int quadrature, const int g, const int k) {
  const Orbit orbit = orbits[quadrature][g / 3];
  return g % 3 == k ? orbit.alpha : orbit.beta();
}

/// At a Gauss point of quadrature 0: g and (1/u) dg/du; `inside`: u < 1 in all lanes.
template <bool inside, bool fourth_order>
inline void profile_g(const V r2, V &value, V &slope) {
  using K = Kernel<3, fourth_order>;
  const V u = root(r2);
  value = K::share(u, r2, 42. * K::alpha);
  slope = K::share_slope(u, 42. * K::alpha);
  if constexpr (!inside) {
    const V one = splat(1.), iu = reciprocal(u), outside = iu * iu * iu;
    value = select_less(u, one, value, outside);
    slope = select_less(u, one, slope, splat(-3.) * outside * (iu * iu));
  }
}
/// At a point of the others.
template <bool fourth_order>
inline void profile_d(const V r2, V &value, V &slope) {
  using K = Kernel<3, fourth_order>;
  const V one = splat(1.), ir = rsqrt(r2), u = r2 * ir, w = positive(one - u), w2 = w * w, ir2 = ir * ir;
  value = -(w2 * w2 * w) * K::beyond(u) * (ir2 * ir);
  slope = ir2 * (splat(42. * K::alpha) * K::value(w) - splat(3.) * value);
}
}  // namespace
}  // namespace turgor::sph
