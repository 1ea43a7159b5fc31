// Closed form: a ring under pressure (2D slab) squeezed between two smooth plates.
//
// Nothing pulls along the ring, so its tension F is the same everywhere; free parts are arcs of radius F/(p
// z0). Between plates at a distance 2 r that makes two half circles of radius r and two straight parts of
// length b, those on the plates:
//
//   perimeter  2 pi r + 2 b = lambda L0        area  pi r^2 + 2 r b
//   balance    F(lambda) = p(area) r z0        force on a plate  p z0 b
//
// At constant area pi R^2, r = R (1 - e):  lambda/lambda_0 = (1 + (1 - e)^2)/(2 (1 - e)),  force = F (pi/2)
// ((1 - e)^-2 - 1). So even a tension that does not grow at all leaves a force of slope pi F (1 - e)^-3: over
// 25 to 30 % it is 1.222 times as steep as over 20 to 25 %, whatever the wall. Only a tension that falls, or
// a cell that loses area, is straighter.
//
// In: SI. Out: force in N. Bending is left out.
#pragma once

#include "micro/solve/bisection.h"
#include "micro/laws/neo_hookean_wall.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace turgor {
struct SqueezedRing {
  NeoHookeanWall law;
  double rest_length = 0.;                         ///< m, L0
  double depth = 0.;                               ///< m, z0
  std::function<double(double)> pressure_of_area;  ///< Pa of m^2, falling

  struct State {
    double flat = 0., stretch = 1., pressure = 0., force = 0.;  ///< m (b), 1, Pa, N
  };

  /// Between plates at half-height r (m), at most radius(). Throws std::runtime_error where there is no such
  /// state, as radius() does.
  State between(const double r) const {
    constexpr double pi = std::numbers::pi;
    const auto at = [&](const double b) {
      State s;
      s.flat = b;
      s.stretch = 2. * (pi * r + b) / rest_length;
      s.pressure = pressure_of_area(r * (pi * r + 2. * b));
      s.force = s.pressure * depth * b;
      return s;
    };
    // tension grows and pressure falls with b, but for a wall that gives way faster than its fluid
    const auto slack = [&](const double b) {
      const State s = at(b);
      return law.force(s.stretch) < s.pressure * r * depth;
    };
    if (!slack(0.))  // they only just touch
      return at(0.);
    return at(bisect(0., rest_length, slack, "the flat length (m) of a ring between plates"));
  }

  /// Half-height at which the plates only just touch: b = 0, the free ring.
  double radius() const {
    const auto slack = [&](const double r) {
      return law.force(2. * std::numbers::pi * r / rest_length) <
             pressure_of_area(std::numbers::pi * r * r) * r * depth;
    };
    return bisect(0.25 * rest_length / std::numbers::pi, rest_length / std::numbers::pi, slack,
                  "the radius (m) of the free ring");
  }

  double force(const double deformation) const {
    return between(radius() * (1. - deformation)).force;
  }  ///< N

  /// Slope of the force over 25 to 30 % against 20 to 25 %: 1.22 for a tension that does not grow at all.
  double stiffening() const { return (force(0.30) - force(0.25)) / (force(0.25) - force(0.20)); }
};
}  // namespace turgor
