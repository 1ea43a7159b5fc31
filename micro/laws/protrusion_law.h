// A protrusion that has hold of a node of the matrix (thesis 2.3.3, Fig. 2.10A): a spring in line with a
// contractile element, which gets shorter the slower the nearer its tension F is to a stall force F_s,
//
//   dc/dt = v_0 (1 - F/F_s)       F = k_pro max(0, l - l_rest), the element's contraction c takes from l_rest
//
// and stalls where little of v_0 is left. After a rest F_s rises by 20 pN, and the focal adhesion gets as
// many new sites as each of these steps has. The element's work is limited: W = integral of F dc comes to
// F^2/(2 K_eff), 1/K_eff = 1/k_pro + 1/k_ECM (2.41) where the matrix is a spring, so that force on a stiff
// matrix goes higher. At the limit the element lets out again, with a time of its own.
//
// Bonds of the adhesion in the mean field of their number N, equally loaded catch bonds (thesis, after
// [174]; Novikova and Storm 2013, 10.1016/j.bpj.2013.07.039):
//
//   dN/dt = k_on (sites - N) - N k_off(F/N),   k_off(f) = cosh((f - f_best)/f_0)/T_longest
//
// A protrusion lets go at the end of its lifetime, or where less than one bond is left.
//
//   ProtrusionLaw law;  ProtrusionState s = law.begin(l);  law.advance(s, l, h);  law.tension(s, l)
//
// In and out: m, N, s, J.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace turgor {
struct ProtrusionState {
  enum class Phase : std::uint8_t { pulling, resting, letting_out };
  double rest = 0.;                       ///< m, length without force
  double stall = 0.;                      ///< N, F_s
  double bonds = 0.;                      ///< N
  double work = 0.;                       ///< J, W
  double pulled = 0., force_before = 0.;  ///< m, N: by the last advance, and where it began
  double age = 0., resting_since = 0.;    ///< s
  Phase phase = Phase::pulling;
};

struct ProtrusionLaw {
  double stiffness = 1e-3;                           ///< N/m, k_pro
  double speed = 5e-7;                               ///< m/s, v_0
  double stall_step = 20e-12;                        ///< N; of the first F_s, and by which it rises
  double stalled = 0.05;                             ///< of v_0: slower is stalled
  double resting = 1.;                               ///< s
  double work_limit = 1e-15;                         ///< J, W_max
  double relaxation = 30.;                           ///< s, of the letting out
  double lifetime = 240.;                            ///< s, T_pro
  double sites = 10.;                                ///< new ones with each step of F_s
  double binding = 1.;                               ///< 1/s, k_on
  double longest_bond = 10.;                         ///< s, T_longest
  double best_force = 30e-12, force_scale = 10e-12;  ///< N, f_best, f_0

  ProtrusionState begin(const double length) const {
    ProtrusionState s;
    s.rest = length;
    s.stall = stall_step;
    s.bonds = sites * binding / (binding + unbinding(0.));
    return s;
  }
  double tension(const ProtrusionState &s, const double length) const {
    return stiffness * std::max(0., length - s.rest);
  }
  double energy(const ProtrusionState &s, const double length) const {
    const double stretch = std::max(0., length - s.rest);
    return 0.5 * stiffness * stretch * stretch;
  }
  double unbinding(const double force) const {  ///< 1/s, of one bond
    return std::cosh(std::min(300., std::abs(force - best_force) / force_scale)) / longest_bond;
  }
  double sites_at(const double stall) const { return sites * stall / stall_step; }
  bool is_over(const ProtrusionState &s) const { return s.age >= lifetime || s.bonds < 1.; }

  /// Over h with the ends held at `length`, by the exact course of a matrix that does not give way: where it
  /// does, the force rises slower, and never beyond F_s. The ends then move before the next advance, and the
  /// work of this one is known there, by the trapezoidal rule.
  void advance(ProtrusionState &s, const double length, const double h) const {
    using Phase = ProtrusionState::Phase;
    const double force = tension(s, length);
    s.age += h;
    s.work += 0.5 * (s.force_before + force) * s.pulled;
    s.force_before = force;
    s.pulled = 0.;
    advance_bonds(s, force, h);
    if (s.phase == Phase::letting_out) {
      s.rest += force / stiffness * -std::expm1(-h / relaxation);
      return;
    }
    if (s.work >= work_limit * (1. - 1e-6)) {
      s.phase = Phase::letting_out;
      return;
    }
    if (s.phase == Phase::pulling && force >= (1. - stalled) * s.stall) {
      s.phase = Phase::resting;
      s.resting_since = s.age - h;
    }
    if (s.phase == Phase::resting) {
      if (s.age - s.resting_since < resting) return;
      s.phase = Phase::pulling;
      s.stall += stall_step;
    }
    const double rest = s.rest;
    pull(s, length, h);
    s.pulled = rest - s.rest;
  }

 private:
  void pull(ProtrusionState &s, const double length, const double h) const {
    const double slack = std::max(0., s.rest - length), taut = h - slack / speed;
    if (!(taut > 0.)) {
      s.rest -= speed * h;
      return;
    }
    s.rest -= slack;
    const double force = tension(s, length);
    const double by = (s.stall - force) / stiffness * -std::expm1(-stiffness * speed * taut / s.stall);
    // F c + k c^2/2 = what is left of the work
    const double left = std::max(0., work_limit - s.work),
                 most = 2. * left / (force + std::sqrt(force * force + 2. * stiffness * left));
    s.rest -= std::clamp(by, 0., left > 0. ? most : 0.);
  }

  void advance_bonds(ProtrusionState &s, const double force, const double h) const {
    constexpr int parts = 16;
    const double all = sites_at(s.stall);
    for (int k = 0; k < parts; ++k) {
      const double off = unbinding(force / std::max(s.bonds, 1e-3)), rate = binding + off,
                   even = all * binding / rate;
      s.bonds = even + (s.bonds - even) * std::exp(-rate * h / parts);
    }
  }
};
}  // namespace turgor
