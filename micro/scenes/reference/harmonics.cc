#include "micro/scenes/reference/harmonics.h"

#include "micro/solve/eigenvalues.h"
#include "run/number_text.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

namespace turgor {
namespace {
using Eigen::Index;

/// The columns w that make |A w - b| least: A is made orthonormal column by column together with b, which has
/// the accuracy of Householder's way (Bjoerck 1967, 10.1007/BF01934122). A column that the ones before it
/// span has weight nought.
Eigen::VectorXcd least_squares(Eigen::MatrixXcd A, Eigen::VectorXcd b) {
  const Index n = A.cols();
  Eigen::MatrixXcd R = Eigen::MatrixXcd::Zero(n, n);
  Eigen::VectorXcd w = Eigen::VectorXcd::Zero(n);
  for (Index k = 0; k < n; ++k) {
    const double whole = A.col(k).norm();
    for (Index j = 0; j < k; ++j) {
      R(j, k) = A.col(j).dot(A.col(k));
      A.col(k) -= R(j, k) * A.col(j);
    }
    const double left = A.col(k).norm();
    if (!(left > 1e-14 * whole)) {
      A.col(k).setZero();
      continue;
    }
    R(k, k) = left;
    A.col(k) /= left;
    w[k] = A.col(k).dot(b);
    b -= w[k] * A.col(k);
  }
  for (Index k = n - 1; k >= 0; --k) {
    for (Index j = k + 1; j < n; ++j) w[k] -= R(k, j) * w[j];
    w[k] = R(k, k) != 0. ? w[k] / R(k, k) : 0.;
  }
  return w;
}
}  // namespace

std::vector<Harmonic> harmonics(const std::vector<double> &signal, const double dt,
                                const unsigned int count) {
  const Index n = Index(signal.size()), rank = 2 * Index(count) + 1, columns = (n - 1) / 2;
  if (n < 3 * rank + 1)
    throw std::invalid_argument("a signal of " + number_text(n) + " samples is too short for " +
                                number_text(count) + " harmonics");
  // Square (of an even number of samples the last is left out here), so symmetric: its singular values are
  // its eigenvalues' sizes, its singular vectors their vectors.
  Eigen::MatrixXd hankel(columns + 1, columns + 1);
  for (Index i = 0; i <= columns; ++i)
    for (Index k = 0; k <= columns; ++k) hankel(i, k) = signal[std::size_t(i + k)];
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(hankel);
  const Eigen::VectorXd size = modes.eigenvalues().cwiseAbs();
  std::vector<Index> order(static_cast<std::size_t>(columns + 1));
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(), [&](const Index a, const Index b) { return size[a] > size[b]; });
  Index kept = 0;
  while (kept < std::min(rank, columns + 1) && size[order[std::size_t(kept)]] > 1e-12 * size[order[0]])
    ++kept;
  if (kept == 0) return {};
  Eigen::MatrixXd V(columns + 1, kept);
  for (Index m = 0; m < kept; ++m) V.col(m) = modes.eigenvectors().col(order[std::size_t(m)]);

  // The least-squares map from V without its last row to V without its first. V'V = 1, so that the normal
  // matrix of the former is 1 - v v' with its last row v, whose inverse is 1 + v v'/(1 - v'v).
  const Eigen::VectorXd v = V.row(columns).transpose();
  Eigen::MatrixXd map = V.topRows(columns).transpose() * V.bottomRows(columns);
  map += v * (v.transpose() * map) / (1. - v.squaredNorm());
  const Eigen::VectorXcd z = eigenvalues(map);

  // A growing part would be noise; powers are held back so that the amplitudes stay well conditioned.
  Eigen::MatrixXcd powers(n, kept);
  for (Index m = 0; m < kept; ++m) {
    const std::complex<double> factor = z[m] / std::max(1., std::abs(z[m]));
    std::complex<double> power = 1.;
    for (Index k = 0; k < n; ++k, power *= factor) powers(k, m) = power;
  }
  Eigen::VectorXcd samples(n);
  for (Index k = 0; k < n; ++k) samples[k] = signal[std::size_t(k)];
  const Eigen::VectorXcd weight = least_squares(powers, samples);

  std::vector<Harmonic> parts;
  for (Index m = 0; m < kept; ++m) {
    const std::complex<double> rate = std::log(z[m]) / dt;
    if (rate.imag() > 0. &&
        std::abs(z[m].imag()) > 1e-12)  // of each conjugate pair one; real ones are no oscillation
      parts.push_back({rate.imag(), -rate.real(), 2. * std::abs(weight[m]), std::arg(weight[m])});
  }
  std::sort(parts.begin(), parts.end(),
            [](const Harmonic &a, const Harmonic &b) { return a.amplitude > b.amplitude; });
  return parts;
}

Harmonic largest_between(const std::vector<Harmonic> &parts, const double low, const double high) {
  for (const Harmonic &part : parts)
    if (part.omega > low && part.omega < high &&
        std::abs(std::expm1(-2. * std::numbers::pi * part.decay / part.omega)) <= 0.1)
      return part;
  return {};
}
}  // namespace turgor
