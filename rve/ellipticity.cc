#include "rve/ellipticity.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace turgor {
namespace {
Eigen::SelfAdjointEigenSolver<Tensor2<2>> acoustic(const Tensor4<2> &tangent, const Tensor2<2> &F,
                                                   const double angle) {
  const Vector<2> n = F.transpose() * Vector<2>(std::cos(angle), std::sin(angle));
  Tensor2<2> A = Tensor2<2>::Zero();
  for (int a = 0; a < 2; ++a)
    for (int c = 0; c < 2; ++c)
      for (int b = 0; b < 2; ++b)
        for (int d = 0; d < 2; ++d) A(a, c) += n[b] * tangent(2 * a + b, 2 * c + d) * n[d];
  return Eigen::SelfAdjointEigenSolver<Tensor2<2>>(0.5 / F.determinant() * (A + A.transpose()));
}

double half_turn(const double angle) {
  double rest = std::fmod(angle, std::numbers::pi);
  if (rest < 0.) rest += std::numbers::pi;
  return rest > std::numbers::pi - 1e-6 ? 0. : rest;
}
}  // namespace

LeastAcoustic::LeastAcoustic(const Tensor4<2> &tangent, const Tensor2<2> &F) {
  const auto least = [&](const double angle) { return acoustic(tangent, F, angle).eigenvalues()[0]; };
  constexpr double degree = std::numbers::pi / 180.;
  int best = 0;
  value = least(0.);
  for (int i = 1; i < 180; ++i)
    if (const double here = least(i * degree); here < value) {
      value = here;
      best = i;
    }
  double low = (best - 1) * degree, high = (best + 1) * degree;
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 34; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (least(left) <= least(right) ? high : low) = least(left) <= least(right) ? right : left;
  }
  const double angle = 0.5 * (low + high);
  const auto solved = acoustic(tangent, F, angle);
  value = solved.eigenvalues()[0];
  normal = half_turn(angle);
  const Vector<2> m = solved.eigenvectors().col(0);
  motion = half_turn(std::atan2(m[1], m[0]));
}
}  // namespace turgor
