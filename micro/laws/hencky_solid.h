// An isotropic solid by its logarithmic strain, step by step: Hooke's law (thesis Eq. 2.32 to 2.34,
// corrected: doc/equations.md) with Jaumann's rate by an exact rotation.
//
//   F = I + increment of displacement = R U      polar decomposition of a step
//   S' = R [S + 2 G dev(ln U)] R'                dev(A) = A - tr(A) I/3, in the plane (plane strain) as well
//   p  = K ln(rho/rho_0)                         positive in compression
//
// A rigid motion has U = I however large it is: it turns S and does nothing else. Stresses are Kirchhoff's
// (of the volume at rest), Pa, positive in tension: per volume at rest they store
//   K/2 ln(rho/rho_0)^2 + S:S/(4 G)
//
//   HenckySolid solid{.bulk = 8333., .shear = 862.};
//   solid.step<2>(S, F, 1.)                      S_zz = -S_xx - S_yy is not stored
#pragma once

#include "micro/geometry/tensor.h"

#include <cmath>

namespace turgor {
struct HenckySolid {
  double bulk = 0., shear = 0.;  ///< Pa, K and G

  static HenckySolid of(const double young, const double poisson) {
    return {young / (3. * (1. - 2. * poisson)), young / (2. * (1. + poisson))};
  }

  double pressure(const double density_ratio) const { return bulk * std::log(density_ratio); }  ///< Pa
  /// Pa, per volume at rest; intact: the share of G that is left.
  template <int dim>
  double energy(const double density_ratio, const Tensor2<dim> &S, const double intact) const {
    const double compressed = std::log(density_ratio), zz = dim == 2 ? S.trace() : 0.,
                 square = S.squaredNorm() + zz * zz;
    return 0.5 * bulk * compressed * compressed +
           (intact > 0. && shear > 0. ? square / (4. * shear * intact) : 0.);
  }

  /// S after a step of deformation F; false, and S unchanged: F turns volume inside out.
  template <int dim>
  bool step(Tensor2<dim> &S, const Tensor2<dim> &F, const double intact) const {
    if (!(F.determinant() > 0.)) return false;
    const Eigen::SelfAdjointEigenSolver<Tensor2<dim>> square(F.transpose() * F);
    const Tensor2<dim> &Q = square.eigenvectors();
    const Vector<dim> root = square.eigenvalues().cwiseSqrt(), strain = root.array().log();
    const Tensor2<dim> R = F * Q * root.cwiseInverse().asDiagonal() * Q.transpose();
    Tensor2<dim> stretched = Q * strain.asDiagonal() * Q.transpose();
    stretched.diagonal().array() -= strain.sum() / 3.;
    const Tensor2<dim> sum = S + 2. * shear * intact * stretched;
    S = R * sum * R.transpose();
    S = (0.5 * (S + S.transpose())).eval();
    return true;
  }

  /// Pa, von Mises's equivalent of S.
  template <int dim>
  static double von_mises(const Tensor2<dim> &S) {
    const double zz = dim == 2 ? S.trace() : 0.;
    return std::sqrt(1.5 * (S.squaredNorm() + zz * zz));
  }
};
}  // namespace turgor
