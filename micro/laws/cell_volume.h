// How a cell's volume answers to pressure (thesis 5.1, C.1-C.3, corrected): compressible, harder when
// compressed, with a delay.
//
//   eps = -log(V/V_ref)                            volumetric strain, positive when compressed
//   dp = K d eps,  K = K_0 or, hardening, K_0 V_ref/V                                            (C.1, C.2)
//   eps at rest under p:  p/K_0  or, hardening,  log(1 + p/K_0)                                   (from C.2)
//   gamma_int d eps/dt + K_0 eps = g(p), gamma_int = K_0 T_rel:  d eps/dt = (eps_rest(p) - eps)/T_rel  (C.3)
//
// C.3 is advanced exactly for the pressure at the start of an interval: no limit of stability, first order in
// the interval. Under tension (p < 0, adhesion) both use p/K_0: the hardening law ends at p = -K_0 and says
// nothing of swelling.
//
// In: p (Pa), K_0 (Pa), dt, T (s). Out: strain (no unit).
#pragma once

#include <cmath>

namespace turgor {
struct CellVolumeLaw {
  bool hardening = true;

  double strain_at_rest(const double p, const double K_0) const {
    return hardening && p > 0. ? std::log1p(p / K_0) : p / K_0;
  }

  /// Pa, K of C.2.
  double modulus(const double strain, const double K_0) const {
    return hardening && strain > 0. ? K_0 * std::exp(strain) : K_0;
  }
};

/// Strain after dt of C.3; T = 0: at rest at once.
inline double relaxed_strain(const double strain, const double at_rest, const double dt, const double T) {
  return T > 0. ? at_rest + (strain - at_rest) * std::exp(-dt / T) : at_rest;
}

inline double compressed_volume(const double reference, const double strain) {
  return reference * std::exp(-strain);
}
}  // namespace turgor
