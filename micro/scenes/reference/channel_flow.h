// Flow between two flat plates, closed forms: steady, and its start from rest (Fourier series; J. P. Morris,
// P. J. Fox, Y. Zhu 1997, 10.1006/jcph.1997.5776, their Eq. 23 and 21).
//
// Plates at y = 0 and H. In: y, H in m, t in s, nu = mu/rho in m^2/s. Out: velocity along the plates, m/s.
#pragma once

#include <cmath>
#include <numbers>

namespace turgor {
/// Driven by a body force, steady: 4 U s (1 - s), s = y/H; U: in the middle. The force is 8 nu U/H^2 (m/s^2).
inline double poiseuille_speed(const double U, const double H, const double y) {
  const double s = y / H;
  return 4. * U * s * (1. - s);
}

/// Dragged by the upper plate of speed U, steady.
inline double couette_speed(const double U, const double H, const double y) { return U * y / H; }

namespace channel_flow {
/// sum of term(n) exp(-(n pi)^2 tau) until what is left is nothing, n = step, 2 step, ...
template <class Term>
double series(const double tau, const int from, const int step, const Term &term) {
  double sum = 0.;
  for (int n = from; n < 4000; n += step) {
    const double k = n * std::numbers::pi, decay = std::exp(-k * k * tau);
    sum += term(n, k) * decay;
    if (decay < 1e-16) break;
  }
  return sum;
}
}  // namespace channel_flow

/// The same from rest at t = 0, when force or plate start.
inline double poiseuille_start(const double U, const double H, const double nu, const double t,
                               const double y) {
  const double s = y / H;
  return poiseuille_speed(U, H, y) - channel_flow::series(nu * t / (H * H), 1, 2, [&](int, const double k) {
           return 32. * U / (k * k * k) * std::sin(k * s);
         });
}
inline double couette_start(const double U, const double H, const double nu, const double t, const double y) {
  const double s = y / H;
  return couette_speed(U, H, y) +
         channel_flow::series(nu * t / (H * H), 1, 1, [&](const int n, const double k) {
           return 2. * U / k * (n % 2 == 0 ? 1. : -1.) * std::sin(k * s);
         });
}

/// Pa, that the fluid drags the lower plate along with, over time: mu du/dy there.
inline double couette_lower_stress(const double U, const double H, const double mu, const double nu,
                                   const double t) {
  return mu * U / H * (1. + channel_flow::series(nu * t / (H * H), 1, 1, [](const int n, double) {
                         return n % 2 == 0 ? 2. : -2.;
                       }));
}
inline double poiseuille_lower_stress(const double U, const double H, const double mu, const double nu,
                                      const double t) {
  return mu * U / H * (4. - channel_flow::series(nu * t / (H * H), 1, 2, [](int, const double k) {
                         return 32. / (k * k);
                       }));
}
}  // namespace turgor
