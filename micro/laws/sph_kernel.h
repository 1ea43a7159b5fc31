// The kernel of the plain SPH sums: Wendland C2 (no pairing instability), in two and three dimensions.
//
//   W(r)      =      C (1 - q)^4 (1 + 4 q),   q = r/R < 1, zero beyond;   R = 2 h
//   W'(r) / r = -20 C (1 - q)^3 / R^2,        C = 7/(pi R^2) in 2D, 21/(2 pi R^3) in 3D
//
// In: r in m. Out: W in 1/m^dim (its integral is 1), W'/r in 1/m^(dim + 2) (never positive).
#pragma once

#include <numbers>

namespace turgor {
template <int dim>
class WendlandC2 {
 public:
  /// R, m.
  explicit WendlandC2(const double support)
      : inverse_support(1. / support),
        peak(dim == 2 ? 7. / std::numbers::pi / (support * support)
                      : 21. / (2. * std::numbers::pi) / (support * support * support)) {}

  double value(const double r) const {
    const double q = r * inverse_support, s = 1. - q;
    return q < 1. ? peak * s * s * s * s * (1. + 4. * q) : 0.;
  }

  double slope_over_r(const double r) const {
    const double q = r * inverse_support, s = 1. - q;
    return q < 1. ? -20. * peak * inverse_support * inverse_support * s * s * s : 0.;
  }

 private:
  double inverse_support, peak;
};
}  // namespace turgor
