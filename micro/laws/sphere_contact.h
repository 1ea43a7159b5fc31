// What two spheres that touch do to each other along their line of centres: interchangeable laws of
// centre-based cells.
//
//   R = (1/R_i + 1/R_j)^-1,  E = ((1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j)^-1                    thesis Eq. 2.6
//   delta = R_i + R_j - distance (overlap), F > 0 pushes apart
//
//   Hertz           F = 4/3 E sqrt(R) delta^(3/2),                  a^2 = R delta               Eq. 2.5
//   extended Hertz  F = Hertz - pi W R,                             a^2 = R delta               Eq. 2.7
//   JKR             F = 4 E a^3/(3 R) - sqrt(8 pi W E a^3)          (the total force)           Eq. 2.8
//                   (corrected)
//                   delta = a^2/R - sqrt(2 pi W a/E)                                            Eq. 2.9
//                     (corrected)
//
// JKR has hysteresis: spheres that come closer feel nothing before they touch (delta = 0) and then snap to a
// contact of finite radius; when drawn apart they hold on to delta_off = -(3/4) (pi^2 W^2 R/E^2)^(1/3), where
// a^3 = pi W R^2/(8 E). The largest pull is 3/2 pi W R. Whether a pair was in contact is therefore history,
// kept by the caller. U (J) is the energy along the branch in contact, dU/d(delta) = F, zero for a = 0; with
// c = sqrt(2 pi W/E)
//   U = 8 E a^5/(15 R^2) - 4 E c a^(7/2)/(3 R) + pi W a^2.
//
// Where E itself rises with the overlap, the slope of the force has a part more: dE/d(delta) times dF/dE at
// the same overlap, of which by_modulus is E dF/dE: Hertz's force (adhesion does not grow with E), and for
// JKR, whose contact shrinks where E grows,
//   4 E a^3/(3 R) - E c a^(3/2) - k c sqrt(a)/2,   k = dF/d(delta).
// To these laws spheres are parabolas, so that E and delta enter F/(W R) as E delta^(3/2)/(W sqrt(R)) alone:
// E dF/dE = 2/3 k delta in all three.
//
// In: R (m), E (Pa), W (J/m^2), delta (m). Out: force (N), stiffness dF/d(delta) (N/m), area pi a^2 (m^2),
// energy (J), by_modulus (N).
#pragma once

#include "micro/laws/lanes.h"

#include <cmath>
#include <numbers>

namespace turgor {
/// Of one pair (double), or of several side by side (lanes.h).
template <class Number>
struct ContactOf {
  Number force{}, stiffness{}, area{}, energy{}, by_modulus{};
};
using SphereContact = ContactOf<double>;

/// R of two radii; the same form serves E of two moduli that carry their own 1 - nu^2.
inline double in_series(const double a, const double b) { return a * b / (a + b); }

struct HertzContact {
  static constexpr const char *name = "hertz", *what = "without adhesion (thesis Eq. 2.5)";
  static constexpr bool has_history = false;

  double pull_off(double) const { return 0.; }  ///< N, of a sphere pair of radius R

  bool touching(double, double, const double delta, bool) const { return delta > 0.; }

  SphereContact operator()(const double R, const double E, const double delta) const {
    const double a = std::sqrt(R * delta);  // E sqrt(R) delta^(3/2) = E a delta
    const double force = 4. / 3. * E * a * delta;
    return {force, 2. * E * a, std::numbers::pi * R * delta, 8. / 15. * E * a * delta * delta, force};
  }
};

struct ExtendedHertzContact {
  static constexpr const char *name = "extended_hertz", *what = "a constant pull beside Hertz (2.7)";
  static constexpr bool has_history = false;
  double W = 0.;  ///< J/m^2

  double pull_off(const double R) const { return std::numbers::pi * W * R; }

  bool touching(double, double, const double delta, bool) const { return delta > 0.; }

  SphereContact operator()(const double R, const double E, const double delta) const {
    SphereContact contact = HertzContact()(R, E, delta);
    const double pull = std::numbers::pi * W * R;
    contact.force -= pull;
    contact.energy -= pull * delta;
    return contact;
  }
};

struct JkrContact {
  static constexpr const char *name = "jkr", *what = "adhesion that holds on (2.8, 2.9)";
  static constexpr bool has_history = true;
  double W = 0.;  ///< J/m^2

  double pull_off(const double R) const { return 1.5 * std::numbers::pi * W * R; }

  /// Overlap at which a contact that is drawn apart lets go (negative), m.
  double release(const double R, const double E) const {
    const double s = std::numbers::pi * W / E;
    return -0.75 * std::cbrt(s * s * R);
  }

  bool touching(const double R, const double E, const double delta, const bool before) const {
    return delta >= 0. || (before && delta > release(R, E));
  }

  /// Contact radius of the stable branch, m; delta >= release(). Of one pair or of four, with the same bits.
  template <class Number>
  Number radius(const Number R, const Number E, const Number delta) const {
    using namespace lanes;
    // u = sqrt(a): f = u^4/R - c u - delta is convex; from above Newton's steps only descend, to the largest
    // root.
    const Number c = root(2. * std::numbers::pi * W / E), zero{}, from = cube_root(R * c);
    Number u = root(root(R * where(delta < zero, zero, delta))) + from;
    Number least{};  // where df/du = 0: the release, 0.63 of `from`
    bool near = false;
    auto searching = zero == zero;
    for (int k = 0; k < 60 && any(searching); ++k) {
      const Number u3 = u * u * u, slope = 4. * u3 / R - c, next = u - (u * u3 / R - c * u - delta) / slope;
      const auto descends = slope > zero, lower = next < u;
      if (!near && any(searching & (no(descends) | (next < 0.64 * from)))) {
        near = true;
        least = cube_root(0.25 * R * c);
      }
      u = where(searching, where(descends, where(lower, where(next < least, least, next), u), least), u);
      searching = searching & descends & lower;
    }
    return u * u;
  }

  template <class Number>
  ContactOf<Number> operator()(const Number R, const Number E, const Number delta) const {
    using namespace lanes;
    const Number a = radius(R, E, delta), sqrt_a = root(a), c = root(2. * std::numbers::pi * W / E),
                 area = std::numbers::pi * a * a, zero{};
    // dF/d(delta) = (dF/da) / (d(delta)/da)
    const Number dF = 4. * E * a * a / R - 3. * E * c * sqrt_a, d_delta = 2. * a / R - 0.5 * c / sqrt_a;
    // at the release itself the force falls without bound, and no matrix takes it
    const Number k = where(d_delta > zero, dF / d_delta, zero - HUGE_VAL);
    const Number by_modulus = where(
        d_delta > zero, 4. * E * a * a * a / (3. * R) - E * c * a * sqrt_a - 0.5 * k * c * sqrt_a, zero);
    return {
        4. * E * a * a * a / (3. * R) - 2. * E * c * a * sqrt_a, k, area,
        8. * E * a * a * a * a * a / (15. * R * R) - 4. * E * c * a * a * a * sqrt_a / (3. * R) + W * area,
        by_modulus};
  }
};
}  // namespace turgor
