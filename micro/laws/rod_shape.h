// A cell as a rod: a cylinder of length L and radius R with two half spheres, of constant volume
// (thesis 2.3.3, Fig. 2.8; E. Palsson 2001). Two springs in it pull it back to a sphere of radius R_0:
//
//   V = 4/3 pi R^3 + pi R^2 L = 4/3 pi R_0^3,   E = k/2 L^2 + k/2 (R - R_0)^2
//
//   mu dL/dt = F_z + q a - k L,             a = dV/dL = pi R^2               (thesis after 2.36, corrected:
//   mu dR/dt = F_r + q s - k (R - R_0),     s = dV/dR = 4 pi R^2 + 2 pi R L   one multiplier q, dV/dt = 0)
//
// The multiplier is eliminated by R = R(L), R' = -a/s = -R/(4 R + 2 L): one equation is left,
//
//   mu (1 + R'^2) dL/dt = F_z + R' F_r - dE/dL
//
// so that a force on the rod's side (F_r < 0) makes it longer, and volume is kept to round-off in every step.
//
//   RodShape shape{6e-6, 1e-3};  const RodShape::At at = shape.at(L);  at.radius, at.slope, at.pull
//
// In and out: m, N/m, N.
#pragma once

#include <cmath>
#include <numbers>

namespace turgor {
struct RodShape {
  double rest_radius = 6e-6;  ///< m, R_0
  double stiffness = 0.;      ///< N/m, k

  struct At {
    double radius, slope;     ///< m, R and R'
    double pull;              ///< N, dE/dL
    double pull_over_length;  ///< N/m, dE/dL over L, also where L is 0
    double slope_of_pull;     ///< N/m, k (1 + R'^2): of dE/dL without its small part by R''
  };

  /// m; L >= 0.
  double radius(const double L) const {
    // 4 R^3 + 3 L R^2 = 4 R_0^3 rises and bends upwards: Newton's steps from R_0 only descend
    double R = rest_radius;
    for (int k = 0; k < 60; ++k) {
      const double f = (4. * R + 3. * L) * R * R - 4. * rest_radius * rest_radius * rest_radius,
                   next = R - f / ((12. * R + 6. * L) * R);
      if (!(next < R)) break;
      R = next;
    }
    return R;
  }

  At at(const double L) const {
    const double R = radius(L), slope = -R / (4. * R + 2. * L);
    // (R - R_0)/L = -R^2/(4/3 (R^2 + R R_0 + R_0^2)), with its digits where L is small
    const double thinner = -0.75 * R * R / (R * R + R * rest_radius + rest_radius * rest_radius);
    const double over = stiffness * (1. + thinner * slope);
    return {R, slope, over * L, over, stiffness * (1. + slope * slope)};
  }

  double energy(const double L) const {
    const double thinner = radius(L) - rest_radius;
    return 0.5 * stiffness * (L * L + thinner * thinner);
  }

  double volume() const { return 4. / 3. * std::numbers::pi * rest_radius * rest_radius * rest_radius; }
  /// m^3, of a capsule.
  static double volume(const double R, const double L) {
    return std::numbers::pi * R * R * (4. / 3. * R + L);
  }
};
}  // namespace turgor
