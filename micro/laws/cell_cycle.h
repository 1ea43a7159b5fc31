// The cycle of a cell (thesis 5.3.1 H.III, C.3.2): birth, mitosis without growth, growth with a point of no
// return, division.
//
//   phase 0         birth; it grows only after the mitosis time (1.5 h), phase m = T_mitosis/T
//   phase < 1/4     before the restriction point: where the inhibition f falls below alpha_qui the cell goes
//                   to rest (G0)
//   phase 1         division
//
//   sizer   the phase advances at f/T, so that it is 1 when V_ref has doubled: under compression the cycle is
//           longer
//   timer   the phase advances at 1/T whatever the cell's size
//
// T: cycle time of the uncompressed cell, mitosis included: growth fills T - T_mitosis, and a free population
// doubles in T. (Whether the thesis's 17 h include mitosis is not said; with mitosis on top the population
// would double in 18.5 h.)
//
// A cell that divides within an interval hands the rest of it to its daughters, so that no time is lost to
// the interval. In: times in s, volumes in m^3.
#pragma once

#include "micro/laws/cell_growth.h"

namespace turgor {
struct CellCycle {
  bool timer = false;
  double mitosis = 1.5 * 3600.;   ///< s
  double restriction = 0.25;      ///< phase
  double quiescence_below = 0.3;  ///< alpha_qui, of f
  bool reversible = true;         ///< resting cells go on where f has risen again

  /// Whether a cell rests from now on; f: inhibition.
  bool rests(const bool resting, const double phase, const double f) const {
    if (resting && !reversible) return true;
    return f < quiescence_below && (resting || phase < restriction);
  }

  struct Lived {
    bool rests;
    double left;  ///< of the time, s, when it divides; negative otherwise
  };
  /// A cell over dt at a volumetric strain (cell_growth.h): phase and V_ref follow. held: it rests whatever
  /// its strain is.
  Lived live(const GrowthLaw &growth, const double V_0, const double T, const double strain,
             const bool resting, const bool held, const double dt, double &phase, double &V_ref) const {
    const double f = growth.factor(strain);
    if (held || rests(resting, phase, f)) return {true, -1.};
    return {false, advance(growth, V_0, T, f, dt, phase, V_ref)};
  }

  /// Phase and volume of a cell that does not rest after dt; what is left of dt when it divides, negative
  /// otherwise.
  double advance(const GrowthLaw &growth, const double V_0, const double T, const double f, double dt,
                 double &phase, double &V_ref) const {
    const double m = mitosis / T;
    if (phase < m) {
      const double part = std::min(dt, (m - phase) * T);
      phase = part < dt ? m : phase + part / T;
      dt -= part;
    }
    if (!(dt > 0.)) return -1.;
    const double rate = (timer ? 1. : f) / T;
    const double needed = rate > 0. ? (1. - phase) / rate : HUGE_VAL;
    const double part = std::min(dt, needed);
    V_ref = growth.grown(V_ref, V_0, T - mitosis, f, part);
    phase += rate * part;
    return needed <= dt ? dt - part : -1.;
  }
};
}  // namespace turgor
