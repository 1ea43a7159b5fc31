// The kernels of the sums, lane by lane, and all that follows from their polynomials. Included by
// sph_pairs.inc.h alone and under the rule of sph_sweeps.inc.h: anonymous namespace, no inline function of a
// shared header.
//
//   ordinary       W  = C (1 - u)^4 (1 + 4 u)              Wendland C2; second moment R^2/5 (3D), 5 R^2/36
//                                                          (2D) and a d-th of it in one direction: a wave of
//                                                          wave number k sees W^ = 1 - (k R)^2/30 (3D)
//   fourth order   W* = alpha (1 - beta u^2) W             no second moment: W*^ = 1 - O(k^4).  beta =
//                                                          m_2/m_4, alpha = 1/(1 - beta m_2), m_p = integral
//                                                          of u^p W: 33/10, 50/17 (3D); 55/14, 504/229 (2D)
// Both have a positive Fourier transform (tested): no pairing instability, though W* has a negative ring
// beyond 0.55 R (0.50 R).
//
// With w = (1 - u)^4 (1 + 4 u)(1 - beta u^2) = sum_k c_k u^k the wall's polynomials are
//   u^-d integral_0^u w s^(d-1) ds = sum_k c_k/(d + k) u^k          and its (1/u) d/du.
// In: u = r/R, v = max(0, 1 - u).
#pragma once

#include "micro/terms/sph_lanes.inc.h"

namespace turgor::sph {
namespace {
template <int dim, bool fourth_order>
struct Kernel {
  static constexpr double beta = !fourth_order ? 0. : dim == 2 ? 55. / 14. : 33. / 10.;
  static constexpr double alpha = !fourth_order ? 1. : dim == 2 ? 504. / 229. : 50. / 17.;
  static constexpr int degree = fourth_order ? 7 : 5;
  static constexpr double c[8] = {1.,         0.,        -10. - beta, 20., 10. * beta - 15., 4. - 20. * beta,
                                  15. * beta, -4. * beta};

  /// Peak W(0): 1/m^2, 1/m^3.
  static double peak(const double R) {
    return alpha * (dim == 2 ? 7. / (pi * R * R) : 21. / (2. * pi * R * R * R));
  }
  /// W over the peak.
  static V value(const V v) {
    const V v2 = v * v, w = v2 * v2 * (splat(5.) - splat(4.) * v);
    if constexpr (!fourth_order) return w;
    const V u = splat(1.) - v;
    return w * (splat(1.) - splat(beta) * (u * u));
  }
  /// (1/u) dW/du over -20 times the peak.
  static V slope(const V v) {
    const V v3 = v * v * v;
    if constexpr (!fourth_order) return v3;
    const V u = splat(1.) - v;
    return v3 * (splat(1. + 0.1 * beta) + u * (splat(0.3 * beta) - splat(1.4 * beta) * u));
  }
  /// sum_k scale c_k/(d + k) u^k
  static V share(const V u, const V u2, const double scale) {
    V sum = splat(scale * c[degree] / (dim + degree));
    for (int k = degree - 1; k >= 2; --k) sum = splat(scale * c[k] / (dim + k)) + u * sum;
    return splat(scale * c[0] / dim) + u2 * sum;
  }
  /// (1/u) d share/du
  static V share_slope(const V u, const double scale) {
    V sum = splat(scale * degree * c[degree] / (dim + degree));
    for (int k = degree - 1; k >= 2; --k) sum = splat(scale * k * c[k] / (dim + k)) + u * sum;
    return sum;
  }
  /// 3D: (1 - 42 alpha u^3 share)/v^5: what of the kernel lies beyond u, without cancellation.
  static V beyond(const V u) {
    if constexpr (fourth_order)
      return splat(1.) +
             u * (splat(5.) + u * (splat(15.) - u * (splat(105. / 17.) +
                                                     u * (splat(2310. / 17.) + u * splat(2772. / 17.)))));
    return splat(1.) + u * (splat(5.) + u * (splat(15.) + u * splat(21.)));
  }
};
}  // namespace
}  // namespace turgor::sph
