// How stiff a tangent is at most against any change of F: the largest eigenvalue of its quadratic form.
//
//   result = max over all G of (G : C : G)/(G : G) = largest eigenvalue of (C + C^T)/2
//
// It is what bounds an explicit step of finite elements (macro/stable_step.h says why plane waves alone,
// G = a (x) n, do not; acoustic_bound.h has those). For a stress that resists volume it is reached by G = I.
//
// In: dP/dF (Pa) or dP/dF_dot (Pa s), entry (dim a + b, dim c + d). Out: the same unit, exact to round-off.
//
//   const double bound = quadratic_bound<2>(tangent);
#pragma once

#include "micro/geometry/tensor.h"

#include <Eigen/Eigenvalues>

namespace turgor {
template <int dim>
double quadratic_bound(const Tensor4<dim> &tangent) {
  const Tensor4<dim> symmetric = 0.5 * (tangent + tangent.transpose());
  return Eigen::SelfAdjointEigenSolver<Tensor4<dim>>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}
}  // namespace turgor
