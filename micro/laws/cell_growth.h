// Growth of a cell's uncompressed volume and what slows it down (thesis 5.2, 5.3.1, 5.4.2, C.5).
//
//   dV_ref/dt = f(eps) V_0/T      constant rate;      dV_ref/dt = f(eps) ln 2 V_ref/T      exponential
//                                 (C.5; C.2.1 corrected)
//
// V_0 is the volume at birth, T the time in which an uncompressed cell doubles it. f, the inhibition by the
// volumetric strain eps = -log(V/V_ref) (no unit, positive when compressed):
//
//   none     1
//   hill     e^n/(eps^n + e^n)                     e: threshold, where f = 1/2               (5.2)
//   linear   max(0, 1 - eps/(2 e))                 1 at eps = 0, 1/2 at e                    (5.4.2, "Linear
//            I", "Linear II")
//
// eps <= 0 (a cell that is drawn) counts as 0: f = 1.
#pragma once

#include <algorithm>
#include <cmath>

namespace turgor {
enum class Inhibition { none, hill, linear };
constexpr const char *words_of(Inhibition) { return "none|hill|linear"; }

struct GrowthLaw {
  bool exponential = false;
  Inhibition inhibition = Inhibition::hill;
  double threshold = 0.35;  ///< e
  double exponent = 1.;     ///< n

  double factor(const double strain) const {
    if (inhibition == Inhibition::none || !(strain > 0.)) return 1.;
    if (inhibition == Inhibition::linear) return std::max(0., 1. - 0.5 * strain / threshold);
    return 1. / (1. + std::pow(strain / threshold, exponent));
  }

  /// m^3, V_ref after dt (s) at inhibition f.
  double grown(const double V_ref, const double V_0, const double T, const double f, const double dt) const {
    return exponential ? V_ref * std::exp2(f * dt / T) : V_ref + f * V_0 * dt / T;
  }
};
}  // namespace turgor
