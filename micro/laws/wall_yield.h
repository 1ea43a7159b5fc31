// Yielding of the cell wall: the share of its stiffness that is left at a stretch.
//
//   g(lambda) = 1 - (2 B/pi) atan(A (lambda - 1))  for lambda > 1,  1 below        thesis Eq. 3.8 (corrected)
//
// For lambda < 1 the printed formula would stiffen the wall towards G (1 + B): plain G there. g falls from 1
// to 1 - B, half of the way at lambda = 1 + 1/A. B = 0: no yielding. A law multiplies its force by g; what
// becomes of the force on the way back (reversible, or permanent stretch) is told where the law is used
// (micro/processes/wall_yielding.h).
//
// In: lambda (no unit). Out: g and dg/dlambda (no unit).
#pragma once

#include <cmath>
#include <numbers>

namespace turgor {
struct WallYield {
  double sharpness = 15.;  ///< A: the higher, the sooner the wall gives way
  double drop = 0.;        ///< B in [0, 1]: share of the stiffness lost at large stretch; 0: none

  bool active() const { return drop > 0.; }

  double share(const double lambda) const {
    return lambda > 1. ? 1. - 2. * drop / std::numbers::pi * std::atan(sharpness * (lambda - 1.)) : 1.;
  }

  double derivative(const double lambda) const {
    if (!(lambda > 1.)) return 0.;
    const double x = sharpness * (lambda - 1.);
    return -2. * drop / std::numbers::pi * sharpness / (1. + x * x);
  }
};
}  // namespace turgor
