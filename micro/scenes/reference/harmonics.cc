#include "micro/scenes/reference/harmonics.h"

#include "run/number_text.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

namespace turgor {
std::vector<Harmonic> harmonics(const std::vector<double> &signal, const double dt,
                                const unsigned int count) {
  using Eigen::Index;
  const Index n = Index(signal.size()), rank = 2 * Index(count) + 1, columns = n / 2;
  if (n < 3 * rank + 1)
    throw std::invalid_argument("a signal of " + number_text(n) + " samples is too short for " +
                                number_text(count) + " harmonics");
  Eigen::MatrixXd hankel(n - columns, columns + 1);
  for (Index i = 0; i < hankel.rows(); ++i)
    for (Index k = 0; k <= columns; ++k) hankel(i, k) = signal[std::size_t(i + k)];
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(hankel, Eigen::ComputeThinV);
  Index kept = 0;
  while (kept < std::min(rank, svd.singularValues().size()) &&
         svd.singularValues()[kept] > 1e-12 * svd.singularValues()[0])
    ++kept;
  if (kept == 0) return {};
  const Eigen::MatrixXd V = svd.matrixV().leftCols(kept);
  const Eigen::MatrixXd map = V.topRows(columns).colPivHouseholderQr().solve(V.bottomRows(columns));
  const Eigen::VectorXcd z = Eigen::EigenSolver<Eigen::MatrixXd>(map, false).eigenvalues();

  // A growing part would be noise; powers are held back so that the amplitudes stay well conditioned.
  Eigen::MatrixXcd powers(n, kept);
  for (Index m = 0; m < kept; ++m) {
    const std::complex<double> factor = z[m] / std::max(1., std::abs(z[m]));
    std::complex<double> power = 1.;
    for (Index k = 0; k < n; ++k, power *= factor) powers(k, m) = power;
  }
  Eigen::VectorXcd samples(n);
  for (Index k = 0; k < n; ++k) samples[k] = signal[std::size_t(k)];
  const Eigen::VectorXcd weight = powers.colPivHouseholderQr().solve(samples);

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
