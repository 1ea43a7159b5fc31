// What turgor a closed wall holds in 2D. A ring of perimeter P = lambda P_0 and area A = P^2/c, its tension F
// the same all along, balances
//
//   p = F(lambda) P/(2 A z0) = c F(lambda)/(2 lambda P_0 z0)      c = 4 pi: round, 8 sqrt(3): regular hexagon
//
// F/lambda of a neo-Hookean wall rises to G t0 z0 and no further; with yielding it has a maximum and falls.
// Above the largest p there is no state at rest: such a wall stretches without end.
//
//   if (turgor >= turgid_limit(law, round_cell, 4. * period, depth).pressure) ...
#pragma once

#include "micro/solve/bisection.h"
#include "micro/laws/neo_hookean_wall.h"

#include <numbers>

namespace turgor {
struct TurgidLimit {
  double pressure = 0.;  ///< Pa, the most that is held
  double stretch = 1.;   ///< where; the end of the search where p rises throughout
};

constexpr double round_cell = 4. * std::numbers::pi, hexagonal_cell = 8. * std::numbers::sqrt3;  ///< c

/// rest_perimeter P_0: m, depth z0: m.
inline TurgidLimit turgid_limit(const NeoHookeanWall &law, const double shape, const double rest_perimeter,
                                const double depth) {
  TurgidLimit limit;
  for (double lambda = 1.; lambda < 50.; lambda *= 1.001)
    if (const double p = shape * law.force(lambda) / (2. * lambda * rest_perimeter * depth);
        p > limit.pressure)
      limit = {p, lambda};
  return limit;
}

/// The stretch at which `pressure` (Pa) is held, on the way up. Throws std::runtime_error where there is
/// none.
inline double turgid_stretch(const NeoHookeanWall &law, const double shape, const double rest_perimeter,
                             const double depth, const double pressure) {
  const auto slack = [&](const double lambda) {
    return shape * law.force(lambda) < 2. * pressure * lambda * rest_perimeter * depth;
  };
  return bisect(1., turgid_limit(law, shape, rest_perimeter, depth).stretch, slack,
                "the stretch of the turgid wall");
}
}  // namespace turgor
