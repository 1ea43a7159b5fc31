#include "micro/scenes/reference/cylinder_array.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Dense>

namespace turgor {
namespace {
constexpr int orders = 20, points = 80;  // to 1e-6 of the drag at c = 0.5
using Derivatives = std::array<double, 4>;

/// Lengths over half a period. Derivatives of r^m, from the function to the third.
Derivatives power(const double r, const int m, const double scale = 1.) {
  Derivatives all{};
  double factor = scale;
  for (int d = 0; d < 4; ++d) {
    all[std::size_t(d)] = factor * std::pow(r, m - d);
    factor *= m - d;
  }
  return all;
}

/// Two radial functions of order n that vanish with their slope at r = a; of order 1 the first is r ln r and
/// what it takes for that.
std::array<Derivatives, 2> radial(const int n, const double a, const double r) {
  const auto all = [n, a](const double at) {
    const Derivatives logarithm{at * std::log(at), std::log(at) + 1., 1. / at, -1. / (at * at)};
    const double small = std::pow(a, n);
    return std::array<Derivatives, 4>{n == 1 ? logarithm : power(at, n), power(at, n + 2),
                                      n == 1 ? power(at, 1) : power(at, 2 - n, small), power(at, -n, small)};
  };
  const auto wall = all(a), here = all(r);
  Eigen::Matrix2d take;
  take << wall[2][0], wall[3][0], wall[2][1], wall[3][1];
  std::array<Derivatives, 2> two{};
  for (std::size_t q = 0; q < 2; ++q) {
    const Eigen::Vector2d by = take.inverse() * Eigen::Vector2d(wall[q][0], wall[q][1]);
    for (std::size_t d = 0; d < 4; ++d) two[q][d] = here[q][d] - by[0] * here[2][d] - by[1] * here[3][d];
  }
  return two;
}

/// Of one term sin(n angle) f(r): psi, d psi/dx, vorticity, d vorticity/dx.
std::array<double, 4> term(const Derivatives &f, const int n, const double r, const double angle) {
  const double s = std::sin(n * angle), along = n * std::cos(n * angle) * std::sin(angle) / r,
               square = double(n * n) / (r * r), spin = f[2] + f[1] / r - square * f[0],
               slope = f[3] + f[2] / r - f[1] / (r * r) - square * f[1] + 2. * square / r * f[0];
  return {f[0] * s, f[1] * s * std::cos(angle) - f[0] * along, spin * s,
          slope * s * std::cos(angle) - spin * along};
}
}  // namespace

double cylinder_array_drag(const double c) {
  if (!(c >= 1e-3 && c <= 0.55))
    throw std::invalid_argument("the drag of an array is known from 0.001 to 0.55 of solid");
  const double a = 2. * std::sqrt(c / std::numbers::pi);
  Eigen::MatrixXd A(4 * points, 2 * orders);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(4 * points);
  for (int k = 0; k < points; ++k) {
    const double t = (k + 0.5) / points, r = std::hypot(1., t);
    b[2 * points + k] = 1.;  // psi over what flows through half a period
    for (int order = 0; order < orders; ++order) {
      const int n = 2 * order + 1;
      const auto f = radial(n, a, r);
      for (int q = 0; q < 2; ++q) {
        const auto side = term(f[std::size_t(q)], n, r, std::atan2(t, 1.)),
                   top = term(f[std::size_t(q)], n, r, std::atan2(1., t));
        A(k, 2 * order + q) = side[1];  // no velocity along the sides that the flow crosses
        A(points + k, 2 * order + q) = 0.2 * side[3];
        A(2 * points + k, 2 * order + q) = top[0];
        A(3 * points + k, 2 * order + q) = 0.2 * top[2];  // no friction on those along it
      }
    }
  }
  const Eigen::VectorXd scale = A.colwise().norm().cwiseInverse();
  A = A * scale.asDiagonal();
  const Eigen::VectorXd x = A.colPivHouseholderQr().solve(b);
  return 4. * std::numbers::pi * x[0] * scale[0];
}
}  // namespace turgor
