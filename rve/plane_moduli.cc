#include "rve/plane_moduli.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace turgor {
PlaneModuli::PlaneModuli(const Tensor4<2> &tangent) {
  // Strains xx, yy and the engineering shear, shared by F_xy and F_yx: without stress both of them act alike.
  Eigen::Matrix<double, 4, 3> strain = Eigen::Matrix<double, 4, 3>::Zero();
  strain(0, 0) = strain(3, 1) = 1.;
  strain(1, 2) = strain(2, 2) = 0.5;
  stiffness = strain.transpose() * tangent * strain;
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

double PlaneModuli::shear(const double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  const Eigen::Vector3d g(-2. * c * s, 2. * c * s, c * c - s * s);
  return 1. / g.dot(compliance * g);
}

double PlaneModuli::smallest() const {
  const Eigen::Vector3d unit(1., 1., std::sqrt(2.));  // xy and yx each count
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(unit.asDiagonal() * stiffness * unit.asDiagonal())
      .eigenvalues()[0];
}
}  // namespace turgor
