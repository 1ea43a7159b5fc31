// A rigid disc of radius a that a force per depth F (N/m) moves, in closed form: how fast in a fluid, how far
// in an elastic solid. Plane flow and plane strain; the medium sticks to the disc and to the walls.
#pragma once

#include <cmath>
#include <numbers>

namespace turgor {
/// m/s per N/m, midway between plates at a distance W, a/W < 1/4 (Faxen 1946; Happel, Brenner, Low Reynolds
/// number hydrodynamics, 7-7).
inline double disc_between_walls(const double mu, const double a, const double W) {
  const double k = 2. * a / W, k2 = k * k;
  return (-std::log(k) - 0.9157 + k2 * (1.7244 + k2 * (-1.7302 + k2 * (2.4056 - 4.5913 * k2)))) /
         (4. * std::numbers::pi * mu);
}

/// m per N/m, in the middle of a solid that is held at the radius b: Muskhelishvili's potentials
/// phi = -q ln z + A z^2, psi = kappa q ln z + C/z^2, kappa = 3 - 4 nu, q = F/(2 pi (1 + kappa)).
inline double disc_in_solid(const double G, const double nu, const double a, const double b) {
  const double kappa = 3. - 4. * nu, a2 = a * a, b2 = b * b;
  return (kappa * std::log(b / a) - (b2 - a2) / (kappa * (a2 + b2))) /
         (8. * std::numbers::pi * G * (1. - nu));
}

/// m/s per N/m, in the middle of a fluid within a wall of radius b: the same, incompressible.
inline double disc_in_fluid(const double mu, const double a, const double b) {
  return disc_in_solid(mu, 0.5, a, b);
}
}  // namespace turgor
