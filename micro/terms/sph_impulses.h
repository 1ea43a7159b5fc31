// When a cell's viscosity acts. Its forces (sph_viscosity.inc.h) cost more than a step of water without it,
// and water's viscosity damps the fastest motion a thousand times slower than that moves: so every few steps
// the velocities get one impulse for the time t since the last,
//   v <- P(t M^-1 K) v,   K symmetric and never negative
// P(z) is exp(-z) to first order and between -1 and 1 up to z = s (s + 1): Legendre's polynomial of degree s,
// P_s(1 - 2 z/(s (s + 1))), by its recurrence in s evaluations of the forces (Meyer, Balsara, Aslam
// 2012, 10.1111/j.1365-2966.2012.20744.x). s follows from the fastest rate: linear and angular momentum are
// kept (P(0) = 1), the kinetic energy can only fall. A motion that creeps in a force is too fast by (rate
// t)^2/12. So t is at most 1 over the rate nu k^2 of what is six spacings long, and such a step is the
// longest too (SphFluid::rates); shorter motions are not resolved anyway.
#pragma once

#include "run/archive.h"
#include "micro/geometry/tensor.h"

#include <algorithm>
#include <cmath>
#include <iosfwd>
#include <numbers>

namespace turgor {
template <int dim>
struct SphImpulses {
  static constexpr double most_steps =
      4.;  ///< between impulses: of sound six spacings long a period has several

  double waited = 0.;        ///< s, since the last impulse
  double excess = 1.;        ///< of the fastest rate over its bound: what damped without feeding energy
  double longest = 0.;       ///< s, time between impulses, as of the last
  bool fresh = true;         ///< no impulse yet: the next step has one
  bool within_step = false;  ///< from drift to damp: forces asked for outside are of velocities that somebody
                             ///< may have changed
  bool virial_known = false;
  Tensor2<dim> virial = Tensor2<dim>::Zero();  ///< N m, of the last impulse

  /// A step of dt (s) ends. Whether an impulse of `waited` is due.
  bool due(const double dt) {
    within_step = false;
    waited += dt;
    return fresh || waited + 0.5 * dt > most_steps * dt || waited + dt > longest;
  }
  /// s; 1 over the rate of what is six spacings long. spacing: m, kinematic_viscosity: m^2/s.
  static double longest_time(const double spacing, const double kinematic_viscosity) {
    const double over_k = 6. * spacing / (2. * std::numbers::pi);
    return over_k * over_k / kinematic_viscosity;
  }
  /// s: the least degree for the time waited. rate: 1/s, a bound of the fastest.
  int degree(const double rate) const {
    const double needed = std::ceil(0.5 * (std::sqrt(1. + 4. * waited * rate) - 1.));
    return needed < most_degree ? std::max(1, int(needed)) : most_degree;  // also where it is no number
  }
  /// Of a cell that has been torn to any size the bound grows without end: it has diverged, the scene's own
  /// checks say so, and it must not take hours to come to them. Sound cells need dozens at 1e3 Pa s.
  static constexpr int most_degree = 1000;

  void archive(Archive &a) { a(waited, excess, longest, fresh, virial_known, virial); }
};
}  // namespace turgor
