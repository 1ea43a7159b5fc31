// The width of a strip (Sides = widening) follows so that the mean stress along x is zero, as a wide piece of
// tissue between frictionless plates comes to when it is pressed slowly:
//
//   d ln W = -gain sigma_xx/(7 K) + s     every few steps; x and the period W by the same factor
//
// sigma_xx: mean of the virial over W x height (plates push along y alone); 7 K: the fluid's bulk modulus, an
// upper bound of what resists; s: what the height has lost (d ln h) since, as tissue full of water keeps its
// area. The rest of sigma_xx is reported. No inertia: what is struck is to be held (Sides = periodic), a wide
// piece has no time to widen.
//
// Work of the sides: what the change of width makes of the potential energy, exactly; velocities stay as they
// are. The stress of before times the change is no measure of it: a change takes the stress away, so that up
// to half of that work is never done. At 5 m/s that looked like energy from nothing.
//
// In and out: m, Pa, J.
#pragma once

#include "micro/engine/particle_system.h"

#include <algorithm>
#include <cmath>

namespace turgor {
struct StripWidth {
  double bulk = 0.;  ///< Pa, 7 K
  static constexpr double gain = 0.3;
  static constexpr unsigned int every = 5;  ///< steps

  double work = 0.;   ///< J, done by the sides so far
  double worst = 0.;  ///< Pa, largest |sigma_xx| since the start or since it was set to 0

  /// Pa, mean over the strip; height: m; depth: m. Forces are current.
  static double stress(const ParticleSystem<2> &system, const double height, const double depth) {
    return system.virial()(0, 0) / (system.box.H(0, 0) * height * depth);
  }

  /// lost: what the height has become less since the last time, over itself. Forces are current before and
  /// after.
  void follow(ParticleSystem<2> &system, const double height, const double depth, const double lost) {
    const double sigma = stress(system, height, depth), change = lost - gain * sigma / bulk;
    worst = std::max(worst, std::abs(sigma));
    const double before = system.potential_energy();
    for (double &x : system.particles.x[0]) x *= 1. + change;
    system.box.H.row(0) *= 1. + change;
    system.compute_forces();
    work += system.potential_energy() - before;
  }
};
}  // namespace turgor
