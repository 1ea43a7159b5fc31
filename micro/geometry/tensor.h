// Small fixed-size vectors and matrices (Eigen) used by every particle law.
//
// Conventions of the whole project: r_ij = x_j - x_i, f_ij = force on i from j,
// L_ab = dv_a/dx_b, stress positive in tension, pressure positive in compression.
#pragma once

#include <Eigen/Dense>

namespace turgor {
template <int dim>
using Vector = Eigen::Matrix<double, dim, 1>;

/// Second-order tensor, e.g. F (1), F_dot (1/s), sigma (Pa).
template <int dim>
using Tensor2 = Eigen::Matrix<double, dim, dim>;

/// dP/dF as a (dim*dim) x (dim*dim) matrix; row and column index a*dim+b of P_ab, F_ab.
template <int dim>
using Tensor4 = Eigen::Matrix<double, dim * dim, dim * dim>;
}  // namespace turgor
