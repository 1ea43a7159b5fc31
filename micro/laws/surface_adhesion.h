// What two surfaces that face each other cost per area, by the gap g between them (variational contact:
// forces are its slope),
//
//   r = (g - d0)/h      w = 0                                        r >= 1
//                       w = -W (1 - r^2)^3                           0 <= r < 1
//                       w = -W + 1/2 (k_r + 6 W/h^2) (g - d0)^2      r < 0
//
// W: adhesion energy (J/m^2), kept whatever h is; h: how far adhesion reaches (m), no shorter than a mesh can
// resolve (range_for); d0: the gap at rest (m), of the order of the cortex and more than the sagitta of a
// facet; k_r: resistance to less than it (N/m^3). w and w' are continuous; w'' jumps by k_r at d0, from where
// adhesion pulls back on both sides with 6 W/h^2.
//
// Friction acts by closeness(): 1 up to the gap at rest, (1 - r^2)^3 beyond it.
#pragma once

#include <algorithm>
#include <cmath>

namespace turgor {
struct SurfaceAdhesion {
  double adhesion = 0.;     ///< W, J/m^2
  double range = 0.75e-6;   ///< h, m
  double rest = 0.25e-6;    ///< d0, m
  double stiffness = 3e10;  ///< k_r, N/m^3

  struct Value {
    double energy = 0.;     ///< J/m^2
    double slope = 0.;      ///< Pa, over the gap: positive where the surfaces pull at each other
    double curvature = 0.;  ///< Pa/m
  };

  Value operator()(const double gap) const {
    const double r = (gap - rest) / range;
    if (!(r < 1.)) return {};
    const double pull = 6. * adhesion / (range * range), out = gap - rest;
    if (r < 0.) {
      const double k = stiffness + pull;
      return {-adhesion + 0.5 * k * out * out, k * out, k};
    }
    const double s = 1. - r * r;
    return {-adhesion * s * s * s, pull * out * s * s, pull * s * (1. - 5. * r * r)};
  }

  /// 1, of friction.
  double closeness(const double gap) const {
    const double r = (gap - rest) / range;
    if (!(r < 1.)) return 0.;
    const double s = r > 0. ? 1. - r * r : 1.;
    return s * s * s;
  }

  double reach() const { return rest + range; }  ///< m, from where on nothing is felt
  /// m, of a mesh with edges of that mean length (m): half of it, or h0 if that is longer. With a quarter the
  /// rim of a contact is caught between nodes, wherever they happen to lie: radii 3 to 16 % short of the
  /// energy's minimum.
  static double range_for(const double edge, const double h0) { return std::max(h0, 0.5 * edge); }
};
}  // namespace turgor
