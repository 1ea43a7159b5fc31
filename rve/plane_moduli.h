// Moduli of a tissue in its plane, from the tangent dP/dF of a state without stress (there it is the
// elasticity tensor, relaxed).
//
//   axes x, y, xy:  C = [[C_xx, C_xy, C_xs], [., C_yy, C_ys], [., ., C_ss]],  S = C^-1
//   E(angle) = 1/(n^T S n), laterally free, n = (cos^2, sin^2, cos sin);  held(x) = C_xx
//   shear for stretch along the axes = 1/(S_xx + S_yy - 2 S_xy), for stretch at 45 degrees = 1/S_ss
//   shear(angle) = 1/(g^T S g), g = (-2 cos sin, 2 cos sin, cos^2 - sin^2): simple shear along that line
//
//   const PlaneModuli moduli(answer.tangent);
//
// In and out: Pa (plane strain: nothing moves out of the plane). Of dP/dF_dot the same are viscosities, Pa s.
#pragma once

#include "micro/geometry/tensor.h"

namespace turgor {
struct PlaneModuli {
  explicit PlaneModuli(const Tensor4<2> &tangent);

  double free(double angle) const;   ///< Pa, Young's modulus, sides free; angle in rad from x
  double shear(double angle) const;  ///< Pa, of simple shear along a line; angle in rad from x
  /// Pa, smallest stiffness against any strain (its norm with both shears): positive where the tissue is
  /// stable
  double smallest() const;

  double held_x, held_y;                  ///< Pa, sides held
  double shear_axes, shear_45;            ///< Pa
  Eigen::Matrix3d stiffness, compliance;  ///< Pa, 1/Pa
};
}  // namespace turgor
