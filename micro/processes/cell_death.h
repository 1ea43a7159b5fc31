// Necrosis and lysis (thesis 2.2.2, 5.3.1 H.I, C.1.3, C.2.2).
//
//   necrosis   a cell deeper than the viable rim, edge - r > lambda, dies when its pressure reaches its own threshold p_th
//   lysis      what is left is the solid part, phi of the volume it had uncompressed:
//     delayed  V_ref -> phi V_ref at once; V follows by C.3 with T_lys in place of T_rel (C.1.3)
//     linear   dV_ref/dt = -V_ref(death)/T_lys down to phi V_ref(death), which takes (1 - phi) T_lys (2.12 corrected)
//   lysed      when the volume is within 5 % of the solid part's at rest; the remains stay (in vitro) or are taken away (in vivo)
//
// In linear lysis V_ref(death) is kept in the field `volume_at_death`.
// In: m, Pa, m^3, s.
#pragma once

#include <algorithm>
#include <cmath>

namespace turgor
{
enum class Rim
{
  none,      ///< no limit of nutrients
  quiescent, ///< deeper cells rest (Model II)
  necrotic   ///< deeper cells die at p_th (Model I)
};

struct CellDeath
{
  Rim rim = Rim::none;
  double rim_thickness = 20e-6;       ///< lambda, m
  double necrosis_pressure = 1500.;   ///< mean p_th, Pa
  double lysis_time = 5. * 86400.;    ///< mean T_lys, s
  double solid_fraction = 0.2;        ///< phi
  bool linear = false;                ///< lysis by 2.12
  bool remove = false;                ///< the remains are taken away

  static constexpr double nearly = 0.05; ///< of strain: the end of lysis

  bool dies(const double depth, const double pressure, const double threshold) const
  {
    return rim == Rim::necrotic && depth > rim_thickness && pressure >= threshold;
  }

  /// At death: V stays what it is.
  void die(double &V_ref, double &strain) const
  {
    if (linear)
      return;
    V_ref *= solid_fraction;
    strain += std::log(solid_fraction);
  }

  /// Linear lysis over dt (s): V_ref (m^3); true at its end.
  bool shrink(double &V_ref, const double V_at_death, const double T, const double dt) const
  {
    V_ref = std::max(V_ref - V_at_death * dt / T, solid_fraction * V_at_death);
    return V_ref <= solid_fraction * V_at_death;
  }
};
} // namespace turgor
