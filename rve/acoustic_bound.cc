#include "rve/acoustic_bound.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
double acoustic_bound(const Tensor4<2> &tangent) {
  double largest = 0.;
  for (int i = 0; i < 180; ++i) {
    const double angle = i * std::numbers::pi / 180.;
    const Vector<2> n(std::cos(angle), std::sin(angle));
    Tensor2<2> acoustic = Tensor2<2>::Zero();
    for (int a = 0; a < 2; ++a)
      for (int c = 0; c < 2; ++c)
        for (int b = 0; b < 2; ++b)
          for (int d = 0; d < 2; ++d) acoustic(a, c) += n[b] * tangent(2 * a + b, 2 * c + d) * n[d];
    largest = std::max(largest, Eigen::SelfAdjointEigenSolver<Tensor2<2>>(acoustic).eigenvalues().maxCoeff());
  }
  return largest;
}
}  // namespace turgor
