// Tension of an edge of a cell's cortex over its length l; l0 is its length at rest. A law has
//
//   holds (false: no tension keeps it so long), force (N, positive in tension), energy (J, 0 at rest),
//     stiffness (N/m, d force/dl)
//
//   linear   T = k (l - l0)                                                       thesis B.1 (corrected), k
//            from B.8 (corrected)
//   fene     T = k l/(1 - x^2) - k_p/l^2,  x = l/l_max,  l_max = l0/x0            thesis Eqs. 4.2
//            (corrected), 4.3 k_p = k l0^3/(1 - x0^2): no tension at rest, so that a net of any lengths is
//            free of stress where it was made
//
// A sixfold net of edges has the shear modulus mu = sqrt(3)/4 dT/dl(l0) (N/m) and the area modulus 2 mu;
// linear: E h = (2/sqrt 3) k.
#pragma once

#include <cmath>

namespace turgor {
struct LinearSpring {
  double k = 0.;  ///< N/m

  static constexpr const char *name = "linear";
  bool holds(double, double) const { return true; }
  double force(const double l, const double l0) const { return k * (l - l0); }
  double energy(const double l, const double l0) const { return 0.5 * k * (l - l0) * (l - l0); }
  double stiffness(double, double) const { return k; }

  /// Of a cortex with modulus E (Pa) and thickness h (m), thesis B.8 (corrected).
  static LinearSpring of_cortex(const double E, const double h) { return {0.5 * std::sqrt(3.) * E * h}; }
};

struct FeneSpring {
  double k = 0.;       ///< N/m
  double share = 0.5;  ///< x0, length at rest over the largest length, in (0, 1)

  static constexpr const char *name = "fene";

  bool holds(const double l, const double l0) const { return square_of(l / l0) < 1.; }

  double force(const double l, const double l0) const {
    const double r = l / l0, free = 1. - share * share;
    return k * l0 * (r / (1. - square_of(r)) - 1. / (free * r * r));
  }

  double energy(const double l, const double l0) const {
    const double r = l / l0, free = 1. - share * share;
    return k * l0 * l0 *
           (-0.5 / (share * share) * std::log((1. - square_of(r)) / free) + (1. / r - 1.) / free);
  }

  double stiffness(const double l, const double l0) const {
    const double r = l / l0, x2 = square_of(r), free = 1. - share * share;
    return k * ((1. + x2) / ((1. - x2) * (1. - x2)) + 2. / (free * r * r * r));
  }

  /// Of a sixfold net with a shear modulus (N/m) at rest.
  static FeneSpring of_net(const double shear_modulus, const double share) {
    const double slope = FeneSpring{1., share}.stiffness(1., 1.);
    return {4. / std::sqrt(3.) * shear_modulus / slope, share};
  }

 private:
  double square_of(const double r) const { return share * share * r * r; }  ///< x^2
};
}  // namespace turgor
