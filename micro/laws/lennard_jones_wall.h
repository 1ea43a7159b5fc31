// Repulsion between a fluid particle i and a wall node j, thesis Eq. 3.7 (corrected):
//
//   force on i  f_i = f_0 [(r_0/r)^8 - (r_0/r)^4] (x_i - x_j)/r^2   for r < r_0, zero beyond (no attraction)
//   energy      U   = f_0/8 [(r_0/r)^4 - 1]^2,                      f_i = -dU/dx_i, and -f_i acts on the node
//
// The thesis leaves f_0 (N m) and r_0 (m) open. Here r_0 is a multiple of the fluid spacing s, and f_0 is
// what holds turgor p where a fluid lattice expects its wall, half a spacing away: a layer of fluid
// particles carries p s z_0 each (z_0 the depth), a straight row of nodes with spacing l pushes, averaged
// along it, by
//
//   f_0/l I(s/2),   I(a) = integral of [(r_0/r)^8 - (r_0/r)^4] a/r^2 dt,  r^2 = a^2 + t^2 < r_0^2
//
// so f_0 = strength p s l z_0 / I(s/2). In three dimensions a fluid layer carries p s^2 a particle, a flat
// net of nodes with the area A each pushes f_0/A J(s/2), J(a) = integral of the same over the plane, and f_0
// = strength p s^2 A / J(s/2). Particles settle in the gaps between nodes, where the push is less than its
// average along the row: with strength = 4 the fluid keeps half a spacing from the wall indeed (the reference
// cell then holds its turgor with the mass that fills it at rho(turgor), within 0.7 %; with 1 it takes 3 %
// more).
#pragma once

#include <cmath>
#include <numbers>

namespace turgor {
class LennardJonesWall {
 public:
  /// f_0 in N m, r_0 in m.
  LennardJonesWall(const double strength_, const double range_) : f_0(strength_), r_0(range_) {}

  /// The choice above; pressure (Pa), fluid spacing, wall spacing, depth and range (m). Needs range >
  /// fluid_spacing / 2.
  static LennardJonesWall holding(const double pressure, const double fluid_spacing,
                                  const double wall_spacing, const double depth, const double range,
                                  const double strength) {
    const double a = 0.5 * fluid_spacing, half = std::sqrt(range * range - a * a);
    const LennardJonesWall unit(1., range);
    const int points = 2000;
    double integral = 0.;
    for (int k = 0; k < points; ++k) {
      const double t = half * (2. * (k + 0.5) / points - 1.);
      integral += unit.force_over_r(std::hypot(a, t)) * a * 2. * half / points;
    }
    return {strength * pressure * fluid_spacing * wall_spacing * depth / integral, range};
  }

  /// The same in three dimensions; node_area: m^2 of wall a node.
  static LennardJonesWall holding_net(const double pressure, const double fluid_spacing,
                                      const double node_area, const double range, const double strength) {
    // r dr = t dt: J(a) = 2 pi a integral of [(r_0/r)^8 - (r_0/r)^4] / r dr from a to r_0
    const double s2 = 4. * range * range / (fluid_spacing * fluid_spacing), s4 = s2 * s2, s8 = s4 * s4;
    const double J = std::numbers::pi * fluid_spacing * ((s8 - 1.) / 8. - (s4 - 1.) / 4.);
    return {strength * pressure * fluid_spacing * fluid_spacing * node_area / J, range};
  }

  /// f_i = force_over_r (x_i - x_j), N/m; r in m.
  double force_over_r(const double r) const {
    if (!(r < r_0)) return 0.;
    const double s2 = r_0 * r_0 / (r * r), s4 = s2 * s2;
    return f_0 * (s4 * s4 - s4) / (r * r);
  }

  /// J.
  double energy(const double r) const {
    if (!(r < r_0)) return 0.;
    const double s = r_0 / r, s4 = s * s * s * s;
    return f_0 / 8. * (s4 - 1.) * (s4 - 1.);
  }

  /// d^2U/dr^2, N/m, where the repulsion is `force` (N): how stiff the wall gets before it gives way.
  double stiffness_at(const double force) const {
    double low = 0.01 * r_0, high = r_0;  // force falls with r: bisection
    for (int k = 0; k < 60; ++k) {
      const double r = 0.5 * (low + high);
      (force_over_r(r) * r > force ? low : high) = r;
    }
    const double s = r_0 / low, s4 = s * s * s * s;
    return f_0 * (9. * s4 * s4 - 5. * s4) / (low * low);
  }

  double range() const { return r_0; }
  double strength() const { return f_0; }

 private:
  double f_0, r_0;
};
}  // namespace turgor
