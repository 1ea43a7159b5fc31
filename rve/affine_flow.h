// Viscous stress of a fluid that flows affinely with F:
//
//   sigma = mu (L + L^T + tr(L) I),  L = F_dot F^-1,  P = J sigma F^-T          Eq. 2.24 with 3.17 (errata)
//
// In: mu (Pa s), F (no unit), F_dot (1/s). Out: Pa.
//
//   const AffineFlow<2> flow(mu, F, F_dot);
//   P += flow.P();
#pragma once

#include "micro/geometry/tensor.h"

namespace turgor {
template <int dim>
class AffineFlow {
 public:
  AffineFlow(const double mu, const Tensor2<dim> &F_, const Tensor2<dim> &F_dot)
      : viscosity(mu), J(F_.determinant()), F_inverse(F_.inverse()), L(F_dot * F_inverse) {}

  Tensor2<dim> sigma() const { return of(L); }
  Tensor2<dim> P() const { return J * sigma() * F_inverse.transpose(); }

  /// Pa s, largest G : dP/dF_dot : G over |G|^2 at F = I. With D = sym G it is mu (2 D : D + tr(D)^2), and
  /// tr(D)^2 <= dim D : D <= dim |G|^2: (2 + dim) mu, reached by G = I alone. Plane waves reach 3 mu.
  /// Elsewhere at most J/lambda^2 times that, lambda the smallest stretch: P : G = J sigma : L, |L| <=
  /// |G|/lambda.
  static double largest_viscosity(const double mu) { return (2. + dim) * mu; }

  /// dP/dF at fixed F_dot: dJ = J tr(dL), dF^-T = -dL^T F^-T, dL_flow = -L dL for dF = dL F.
  Tensor4<dim> tangent() const {
    const Tensor2<dim> stress = sigma();
    return by_column([&](const Tensor2<dim> &dL) -> Tensor2<dim> {
      return J * (dL.trace() * stress + of(-L * dL) - stress * dL.transpose()) * F_inverse.transpose();
    });
  }

  /// dP/dF_dot at fixed F: dL = dF_dot F^-1.
  Tensor4<dim> rate_tangent() const {
    return by_column(
        [&](const Tensor2<dim> &dL) -> Tensor2<dim> { return J * of(dL) * F_inverse.transpose(); });
  }

 private:
  template <class Change>
  Tensor4<dim> by_column(const Change &dP_of) const {
    Tensor4<dim> result;
    for (int k = 0; k < dim * dim; ++k) {
      Tensor2<dim> dL = Tensor2<dim>::Zero();
      dL.row(k / dim) = F_inverse.row(k % dim);
      const Tensor2<dim> dP = dP_of(dL);
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b) result(dim * a + b, k) = dP(a, b);
    }
    return result;
  }

  Tensor2<dim> of(const Tensor2<dim> &rate) const {
    return viscosity * (rate + rate.transpose() + rate.trace() * Tensor2<dim>::Identity());
  }

  double viscosity, J;
  Tensor2<dim> F_inverse, L;
};
}  // namespace turgor
