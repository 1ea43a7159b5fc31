// Bending of the cell wall: a hinge at the middle one of three consecutive wall nodes.
//
//   E = B (theta - theta_0)^2 / (2 l),  theta = atan2(a x b, a . b),  a = x1 - x0, b = x2 - x1
//
// errata B.7: the turning angle keeps its sign (counter-clockwise positive) and the forces
// conserve momentum and angular momentum exactly, because theta depends on a and b only and
// is invariant under rotation. theta_0 = 0 on flat sides, pi/2 at the corners of a square.
//
// In: edges (m), B/l (N m), theta_0 (rad). Out: angle (rad), its derivatives, energy (J). RingWall makes the
// forces.
#pragma once

#include "micro/geometry/tensor.h"

#include <cmath>

namespace turgor {
struct WallBending {
  double stiffness;  ///< B / l, N m

  static double angle(const Vector<2> &a, const Vector<2> &b) {
    const double cross = a[0] * b[1] - a[1] * b[0], dot = a[0] * b[0] + a[1] * b[1];
    // Most hinges are nearly flat: the series of atan, exact to round-off below 0.1 and five times as fast.
    if (std::abs(cross) < 0.1 * dot) {
      const double t = cross / dot, q = t * t;
      return t +
             t * q *
                 (-1. / 3. +
                  q * (1. / 5. +
                       q * (-1. / 7. +
                            q * (1. / 9. + q * (-1. / 11. + q * (1. / 13. + q * (-1. / 15. + q / 17.)))))));
    }
    return std::atan2(cross, dot);
  }

  double energy(const Vector<2> &a, const Vector<2> &b, const double theta_0) const {
    const double t = angle(a, b) - theta_0;
    return 0.5 * stiffness * t * t;
  }

  /// d angle(v) / dv = perp(v)/|v|^2 of the direction angle of an edge v.
  static Vector<2> angle_gradient(const Vector<2> &v) {
    const double s = 1. / (v[0] * v[0] + v[1] * v[1]);
    return {-s * v[1], s * v[0]};
  }

  /// Second derivative of the direction angle of an edge v.
  static Tensor2<2> angle_hessian(const Vector<2> &v) {
    const double n = v[0] * v[0] + v[1] * v[1], s = 1. / (n * n);
    const double xy = 2. * s * v[0] * v[1], yy = s * (v[1] * v[1] - v[0] * v[0]);
    Tensor2<2> h;
    h << xy, yy, yy, -xy;
    return h;
  }
};
}  // namespace turgor
