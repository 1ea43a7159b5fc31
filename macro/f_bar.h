// Deformation gradients of one element with the volume change taken from fewer points (thesis 3.4.3, "4 +
// 1").
//
//   F_bar_q = s_q F_q,   s_q = (J_bar_q / J_q)^(1/dim),   ln J_bar_q = sum_p A_qp ln J_p
//
// q: Gauss points; p: all points of the element; A: TissueMesh::projection. Bilinear: the only p is the
// centre, so J_bar = J_0 there; biquadratic: A projects ln J onto linear functions in the element (the
// stable pair Q2 / P1 discontinuous). Without A: F_bar = F.
//
// Forces are the exact derivative of sum_q w_q W(F_bar_q(u)), including the way J_p and J_q depend on u:
//
//   dF_bar_q = s_q (dF_q + theta_q F_q),   theta_q = (sum_p A_qp F_p^-T : dF_p - F_q^-T : dF_q) / dim
//
// so undamped motion conserves energy, and sum_q w_q P_q : F_bar_dot_q is exactly the internal power.
#pragma once

#include <deal.II/base/tensor.h>

#include <vector>

namespace turgor {
template <int dim>
class FBar {
 public:
  /// The projection has to outlive the element: all elements of a mesh share it.
  FBar(unsigned int nodes, unsigned int gauss_points, unsigned int points,
       const std::vector<double> &projection);

  /// F at the element's points from nodal displacement u (m, [node][dim]) and gradients (1/m, [point][node]).
  /// Returns the first point with det F <= 0 (or not finite), or `points` if there is none.
  unsigned int set(const dealii::Tensor<1, dim> *gradient, const double *u);

  double determinant(unsigned int point) const { return at[point].J; }

  /// F_bar of Gauss point q.
  dealii::Tensor<2, dim> deformation(unsigned int q) const { return at[q].scale * at[q].F; }

  /// Exact derivative of F_bar_q, all q, in the direction v (m/s, [node][dim]).
  void rate(const dealii::Tensor<1, dim> *gradient, const double *v, dealii::Tensor<2, dim> *F_bar_dot);

  /// Adds the nodal forces ([node][dim], N) of the stresses P_q = dW/dF_bar (Pa) with weights w_q.
  void add_forces(const dealii::Tensor<1, dim> *gradient, const double *weight,
                  const dealii::Tensor<2, dim> *P, double *force);

  /// The derivative of the forces of add_forces: (nodes*dim)^2 entries, row-major, N/m; tangent = dP/dF_bar
  /// (Pa).
  void stiffness(const dealii::Tensor<1, dim> *gradient, const double *weight,
                 const dealii::Tensor<2, dim> *P, const dealii::Tensor<4, dim> *tangent, double *matrix);

 private:
  /// All of an element in one piece of memory: between two steps the RVEs drive it out of the cache.
  struct AtPoint {
    dealii::Tensor<2, dim> F, F_inverse_T;
    double J = 0., log_J = 0.;
    double scale = 1.;     ///< Gauss points only
    double dilation = 0.;  ///< F^-1 : dF, or its force
  };

  double A(unsigned int q, unsigned int p) const { return (*projection)[q * n_points + p]; }
  bool projects() const { return !projection->empty(); }

  unsigned int n_nodes, n_gauss, n_points;
  const std::vector<double> *projection;  // [gauss][point], empty: none
  std::vector<AtPoint> at;
};
}  // namespace turgor
