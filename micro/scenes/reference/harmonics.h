// The frequencies in a short signal: a sum of decaying cosines fitted by the matrix pencil.
//
//   y_k = sum_m a_m exp(-d_m k dt) cos(omega_m k dt + phase_m)
//
// With the Hankel matrix H_ik = y_(i+k) and its leading right singular vectors V, exp((-d + i omega) dt) are
// the eigenvalues of the least-squares map from V without its last row to V without its first (Hua and Sarkar
// 1990, 10.1109/29.56027); amplitudes by least squares. A few periods give a frequency to 0.1 %, where the
// bins of a spectrum are as wide as the reciprocal of the time.
//
// In: samples (any unit) every dt, s. Out: rad/s, 1/s, unit of the samples.
#pragma once

#include <vector>

namespace turgor {
struct Harmonic {
  double omega = 0., decay = 0., amplitude = 0., phase = 0.;  ///< rad/s (>= 0), 1/s, of the samples, rad
};

/// At most `count` cosines, largest amplitude first; beside them a constant part is allowed for. Throws
/// std::invalid_argument for less than 6 count + 4 samples.
std::vector<Harmonic> harmonics(const std::vector<double> &signal, double dt, unsigned int count);

/// The largest of those with an omega between low and high that lose (or gain) at most a tenth of their
/// amplitude in a period: what goes faster is no mode but what noise and smoothing leave over, and its
/// frequency an accident. omega 0 where there is none.
Harmonic largest_between(const std::vector<Harmonic> &parts, double low, double high);
}  // namespace turgor
