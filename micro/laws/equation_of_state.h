// Pressure of the cell fluid, with cavitation.
//
//   liquid:    p = K [(rho/rho_0)^7 - 1]                            thesis Eq. 2.22 (bulk modulus 7 K)
//   cavitated: p = p_c + (1/100) (dp/drho)_c (rho - rho_c)          below p_c = p(rho_c)
//
// Water does not carry tension beyond vacuum (default p_c = -100 kPa gauge): bubbles open and
// the mixture keeps 1 % of the liquid's stiffness. p is continuous and monotone, and the
// specific energy e(rho), de/drho = p/rho^2, e(rho_0) = 0, follows it exactly, so opening and
// closing of bubbles is reversible and conserves energy.
//
// In: rho in kg/m^3 (> 0). Out: p in Pa (gauge, positive in compression), e in J/kg, c in m/s.
#pragma once

#include <cmath>

namespace turgor {
class EquationOfState {
 public:
  static constexpr double cavitated_stiffness_ratio = 0.01;

  /// rho_0 (kg/m^3), K (Pa), p_c (Pa gauge, -K < p_c < 0).
  EquationOfState(const double density, const double modulus, const double cavitation_pressure)
      : rho_0(density),
        K(modulus),
        p_c(cavitation_pressure),
        rho_c(density * std::pow(1. + cavitation_pressure / modulus, 1. / 7.)),
        slope_c(cavitated_stiffness_ratio * 7. * (modulus + cavitation_pressure) / rho_c),
        e_c(liquid_energy(rho_c)) {}

  double pressure(const double rho) const {
    if (rho < rho_c) return p_c + slope_c * (rho - rho_c);
    // (1 + d)^7 - 1 without cancellation at small d
    const double d = rho / rho_0 - 1.;
    return K * d * (7. + d * (21. + d * (35. + d * (35. + d * (21. + d * (7. + d))))));
  }

  /// dp/drho = c^2, m^2/s^2.
  double slope(const double rho) const {
    if (rho < rho_c) return slope_c;
    const double x = rho / rho_0, x2 = x * x;
    return 7. * K / rho_0 * x2 * x2 * x2;
  }

  double sound_speed(const double rho) const { return std::sqrt(slope(rho)); }

  /// Specific energy, J/kg; infinite for rho <= 0 or not finite.
  double energy(const double rho) const {
    if (!(rho > 0.) || !std::isfinite(rho)) return HUGE_VAL;
    if (rho < rho_c)
      return e_c + (p_c - slope_c * rho_c) * (1. / rho_c - 1. / rho) + slope_c * std::log(rho / rho_c);
    return liquid_energy(rho);
  }

  /// The density at pressure p (Pa).
  double density_at(const double p) const {
    if (p < p_c) return rho_c + (p - p_c) / slope_c;
    return rho_0 * std::pow(1. + p / K, 1. / 7.);
  }

  double reference_density() const { return rho_0; }
  double cavitation_density() const { return rho_c; }

 private:
  // K/rho_0 (x^6/6 + 1/x - 7/6) with x = 1 + d; its double zero at d = 0 taken out
  double liquid_energy(const double rho) const {
    const double x = rho / rho_0, d = x - 1.;
    return K / rho_0 * d * d * (1. / x + 2.5 + d * (10. / 3. + d * (2.5 + d * (1. + d * (1. / 6.)))));
  }

  double rho_0, K, p_c, rho_c, slope_c, e_c;
};
}  // namespace turgor
