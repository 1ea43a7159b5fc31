// The kernel of the plain SPH sums: Wendland C2 in two dimensions (no pairing instability).
//
//   W(r)      =    7/(pi R^2) (1 - q)^4 (1 + 4 q),   q = r/R < 1, zero beyond;   R = 2 h
//   W'(r) / r = -140/(pi R^4) (1 - q)^3
//
// In: r in m. Out: W in 1/m^2 (its integral over the plane is 1), W'/r in 1/m^4 (never positive).
#pragma once

#include <numbers>

namespace turgor
{
class WendlandC2
{
public:
  /// R, m.
  explicit WendlandC2(const double support)
    : inverse_support(1. / support)
    , peak(7. / std::numbers::pi / (support * support))
  {}

  double value(const double r) const
  {
    const double q = r * inverse_support, s = 1. - q;
    return q < 1. ? peak * s * s * s * s * (1. + 4. * q) : 0.;
  }

  double slope_over_r(const double r) const
  {
    const double q = r * inverse_support, s = 1. - q;
    return q < 1. ? -20. * peak * inverse_support * inverse_support * s * s * s : 0.;
  }

private:
  double inverse_support, peak;
};
} // namespace turgor
