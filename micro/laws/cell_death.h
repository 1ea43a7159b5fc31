// Necrosis and lysis (thesis 2.2.2, 5.3.1 H.I, C.1.3, C.2.2).
//
//   rim        cells deeper than lambda: below the surface near by (depth_below_surface.h) or a wall that
//              they press, or, as the thesis has it (5.4.2), below the mean edge of the spheroid, edge - r >
//              lambda (outer_cells.h)
//   necrosis   a cell deeper than the viable rim dies when its pressure reaches its own threshold p_th
//   lysis      fluid drains until the solid part is left, V_s = phi V_ref(death); V_ref is the volume the
//              cell would have without pressure with the fluid it still has:
//     delayed  V follows by C.3 with T_lys in place of T_rel towards V_s under its pressure (C.1.3)
//     linear   dV_ref/dt = -V_ref(death)/T_lys down to V_s, which takes (1 - phi) T_lys (2.12 corrected)
//   lysed      when the volume is within 5 % of the solid part's at rest; the remains stay (in vitro) or are
//              taken away (in vivo)
//
// C.1.3 sets V_ref to V_s at once. C.3 is linear in the strain log(V_s/V), so it is the sum of what has
// drained, log(V_s/V_ref), which goes to 0 as exp(-t/T_lys), and the elastic strain log(V_ref/V), which goes
// to that at rest with T_lys: the same V(t). Kept apart because the contact's d_ij (C.9) takes the radius of
// a free cell: with V_s the strain of packed dead cells would be negative at once, and the core, which the
// thesis finds stiff (C.2.3), as soft as free cells.
//
// V_ref(death) is kept in the field `volume_at_death`.
// In: m, Pa, m^3, s.
#pragma once

#include <algorithm>
#include <cmath>

namespace turgor {
enum class Rim {
  none,       ///< no limit of nutrients
  quiescent,  ///< deeper cells rest (Model II)
  necrotic    ///< deeper cells die at p_th (Model I)
};
constexpr const char *words_of(Rim) { return "none|quiescent|necrotic"; }

enum class RimFrom {
  surface,  ///< the nearest
  edge      ///< the mean of the spheroid's
};
constexpr const char *words_of(RimFrom) { return "surface|edge"; }

struct CellDeath {
  Rim rim = Rim::none;
  RimFrom from = RimFrom::surface;
  double rim_thickness = 20e-6;      ///< lambda, m
  double necrosis_pressure = 1500.;  ///< mean p_th, Pa
  double lysis_time = 5. * 86400.;   ///< mean T_lys, s
  double solid_fraction = 0.2;       ///< phi
  bool linear = false;               ///< lysis by 2.12
  bool remove = false;               ///< the remains are taken away

  static constexpr double nearly = 0.05;  ///< of strain: the end of lysis

  bool dies(const double depth, const double pressure, const double threshold) const {
    return rim == Rim::necrotic && depth > rim_thickness && pressure >= threshold;
  }

  /// V_ref (m^3) after dt (s) of lysis with T (s).
  double drained(const double V_ref, const double V_at_death, const double T, const double dt) const {
    const double solid = solid_fraction * V_at_death;
    return linear ? std::max(V_ref - V_at_death * dt / T, solid)
                  : solid * std::pow(V_ref / solid, std::exp(-dt / T));
  }

  bool ended(const double V_ref, const double V_at_death, const double strain, const double at_rest) const {
    const double left = std::log(V_ref / (solid_fraction * V_at_death));
    return linear ? left <= 0. : left + at_rest - strain < nearly;
  }
};
}  // namespace turgor
