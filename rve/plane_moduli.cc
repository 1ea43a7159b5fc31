#include "rve/plane_moduli.h"

#include <cmath>

namespace turgor {
PlaneModuli::PlaneModuli(const Tensor4<2> &tangent) {
  // Strains xx, yy and the engineering shear, shared by F_xy and F_yx: without stress both of them act alike.
  Eigen::Matrix<double, 4, 3> strain = Eigen::Matrix<double, 4, 3>::Zero();
  strain(0, 0) = strain(3, 1) = 1.;
  strain(1, 2) = strain(2, 2) = 0.5;
  const Eigen::Matrix3d stiffness = strain.transpose() * tangent * strain;
  compliance = stiffness.inverse();
  held_x = stiffness(0, 0);
  held_y = stiffness(1, 1);
  shear_axes = 1. / (compliance(0, 0) + compliance(1, 1) - 2. * compliance(0, 1));
  shear_45 = 1. / compliance(2, 2);
}

double PlaneModuli::free(const double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  const Eigen::Vector3d n(c * c, s * s, c * s);
  return 1. / n.dot(compliance * n);
}
}  // namespace turgor
