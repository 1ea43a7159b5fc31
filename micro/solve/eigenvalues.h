// All eigenvalues of a real square matrix, complex ones in conjugate pairs. In a file of its own because of
// what a compiler takes for the Schur form.
#pragma once

#include <Eigen/Core>

namespace turgor {
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd &A);
}  // namespace turgor
