#include "micro/solve/eigenvalues.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace turgor {
/// The diagonal of the real Schur form, where a block of two by two is a conjugate pair: as
/// Eigen::EigenSolver has them, without its vectors.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd &A) {
  const Eigen::MatrixXd T = Eigen::RealSchur<Eigen::MatrixXd>(A, false).matrixT();
  Eigen::VectorXcd z(T.rows());
  for (Eigen::Index k = 0; k < T.rows(); ++k)
    if (k + 1 == T.rows() || T(k + 1, k) == 0.)
      z[k] = T(k, k);
    else {
      const double half = 0.5 * (T(k, k) - T(k + 1, k + 1)), middle = T(k + 1, k + 1) + half,
                   size = std::sqrt(std::abs(half * half + T(k + 1, k) * T(k, k + 1)));
      z[k] = {middle, size};
      z[k + 1] = {middle, -size};
      ++k;
    }
  return z;
}
}  // namespace turgor
