// A drop of a liquid with one surface tension gamma between two plates that it does not adhere to: its free
// surface has one mean curvature and leaves the plates along them, so that with the largest radius r_e and
// the radius a of the contact
//
//   r sin psi = c (r^2 - a^2),   c = r_e/(r_e^2 - a^2) = p/(2 gamma),   force F = p pi a^2
//
// (psi: angle of the meridian with the plates; balance of forces on the part above a height). Half the
// distance of the plates is the integral of tan psi dr from a to r_e. From what an experiment measures -
// distance, r_e and F - follow a, the pressure p and the tension gamma.
//
//   const SqueezedDrop drop(6e-6, 11e-6);   drop.pressure(F), drop.tension(F)        m, N
#pragma once

#include "micro/solve/bisection.h"

#include <cmath>
#include <numbers>

namespace turgor {
struct SqueezedDrop {
  double contact;    ///< m, a
  double sharpness;  ///< 1/m, c

  /// half_height, widest: m, with half_height < widest.
  SqueezedDrop(const double half_height, const double widest)
      : contact(bisect(
            0., widest * (1. - 1e-12), [&](const double a) { return height(a, widest) > half_height; },
            "the radius (m) of a drop's contact")),
        sharpness(widest / (widest * widest - contact * contact)) {}

  double pressure(const double force) const {  ///< Pa
    return force / (std::numbers::pi * contact * contact);
  }
  double tension(const double force) const { return 0.5 * pressure(force) / sharpness; }  ///< N/m

  /// m, half the distance of the plates at a radius a of the contact.
  static double height(const double a, const double widest) {
    const double c = widest / (widest * widest - a * a);
    constexpr int pieces = 2000;
    double sum = 0.;
    for (int k = 0; k < pieces; ++k) {
      const double s = std::sin(0.5 * std::numbers::pi * (k + 0.5) / pieces);
      sum += s * (1. + s / std::sqrt(s * s + 4. * c * c * a * a)) / (2. * c);
    }
    return 0.5 * std::numbers::pi / pieces * sum;
  }
};
}  // namespace turgor
