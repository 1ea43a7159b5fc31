// A rod cell (laws/rod_shape.h) squeezed between two parallel plates a distance D apart, lying along them, at
// rest: its one unknown, the length, by bisection of
//
//   0 = -dE/dL - 2 R' (dU/d(delta) + dU/dR),   delta = R - D/2,   U = 8/15 E sqrt(R) delta^(5/2)    (Hertz)
//
// and two limits of it: a body so stiff that it keeps its sphere (Hertz alone), and contacts so stiff that
// R = D/2 (volume alone), where the plates' force is -dE/dD with L = 4/3 (R_0^3 - R^3)/R^2.
//
//   const SqueezedRod rod{{6e-6, 7.4e-4}, 667., 3e-6, 6670.};   rod.length(8e-6), rod.force(8e-6)
//
// In and out: m, Pa, N.
#pragma once

#include "micro/laws/rod_shape.h"
#include "micro/laws/sphere_contact.h"
#include "micro/solve/bisection.h"

#include <algorithm>

namespace turgor {
struct SqueezedRod {
  RodShape shape;
  double modulus;                          ///< Pa, E/(1 - nu^2)
  double nucleus_radius, nucleus_modulus;  ///< m, Pa

  double length(const double distance) const {
    if (!(2. * shape.rest_radius > distance)) return 0.;
    const double most = length_of_volume(distance);
    const auto shorter = [&](const double L) {
      const RodShape::At at = shape.at(L);
      const double delta = at.radius - 0.5 * distance;
      if (!(delta > 0.)) return false;
      const SphereContact c = HertzContact()(at.radius, modulus, delta);
      return -at.pull - 2. * at.slope * (c.force + 0.5 * c.energy / at.radius) > 0.;
    };
    return bisect(0., most * (1. + 1e-9), shorter, "the length (m) of a squeezed rod");
  }

  /// N, on either plate.
  double force(const double distance) const {
    return hertz(shape.radius(length(distance)), modulus, distance) + on_nucleus(distance);
  }
  double force_of_rigid_shape(const double distance) const {
    return hertz(shape.rest_radius, modulus, distance) + on_nucleus(distance);
  }
  double force_of_volume(const double distance) const {
    if (!(2. * shape.rest_radius > distance)) return 0.;
    const RodShape::At at = shape.at(length_of_volume(distance));
    return -0.5 * at.pull / at.slope + on_nucleus(distance);
  }
  double length_of_volume(const double distance) const {
    const double R = 0.5 * distance, R_0 = shape.rest_radius;
    return 4. / 3. * (R_0 * R_0 * R_0 - R * R * R) / (R * R);
  }

 private:
  static double hertz(const double R, const double E, const double distance) {
    const double delta = R - 0.5 * distance;
    return delta > 0. ? HertzContact()(R, E, delta).force : 0.;
  }
  double on_nucleus(const double distance) const {
    return nucleus_radius > 0. ? hertz(nucleus_radius, nucleus_modulus, distance) : 0.;
  }
};
}  // namespace turgor
