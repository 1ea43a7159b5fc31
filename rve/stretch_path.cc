#include "rve/stretch_path.h"

#include <Eigen/Eigenvalues>

namespace turgor {
StretchPath::StretchPath(const Tensor2<2> &from, const Tensor2<2> &to) {
  const Tensor2<2> change = to * from.inverse();
  Eigen::SelfAdjointEigenSolver<Tensor2<2>> squares;
  squares.computeDirect(change * change.transpose());  // V^2
  strain = 0.5 * squares.eigenvalues().array().log();
  axes = squares.eigenvectors();
  turned = axes * (-strain).array().exp().matrix().asDiagonal() * axes.transpose() * to;
}

Tensor2<2> StretchPath::at(const double s) const {
  return axes * (s * strain).array().exp().matrix().asDiagonal() * axes.transpose() * turned;
}
}  // namespace turgor
