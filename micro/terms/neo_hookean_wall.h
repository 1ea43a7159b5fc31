// Tension of a cell wall edge in the 2D slab: incompressible neo-Hookean wall with a
// fixed ratio beta of axial to hoop stress.
//
//   F(lambda) = G t0 z0 (lambda - 1/(alpha^2 lambda^5))            thesis Eq. 3.4 (corrected)
//   alpha^2   = (beta + R)/2,  R = sqrt(beta^2 + 4 (1 - beta)/lambda^6)   thesis Eq. 3.5 (corrected)
//
// With s = lambda^-6, 1/alpha^2 = 2/(beta + R), so F = G t0 z0 lambda (1 - q), q = 2 s/(beta + R),
// and dq/ds = 1/R gives dF/dlambda = G t0 z0 (1 - q + 6 s/R); at lambda = 1: 6/(2 - beta) G t0 z0.
//
// The energy w per reference length (dw/dlambda = F, w(1) = 0) is a hypergeometric function;
// it is tabulated at lambda = exp(k/16) and continued from the nearest knot by 4-point
// Gauss-Legendre, which is exact to round-off there (the nearest complex singularity, at
// lambda^6 = -4 (1 - beta)/beta^2 or 0, is at least 30 interval lengths away: error 100^-8).
//
// In: lambda = length / rest length (no unit, > 0). Out: F, dF in N (positive in tension), w in J/m.
#pragma once

#include <array>
#include <cmath>

namespace turgor
{
class NeoHookeanWall
{
public:
  /// wall_stiffness = G t0 (N/m), depth = z0 (m), beta = axial over hoop stress in [0, 1].
  NeoHookeanWall(const double wall_stiffness, const double depth, const double beta_)
    : scale(wall_stiffness * depth)
    , beta(beta_)
    , beta_squared(beta_ * beta_)
    , four_rest(4. * (1. - beta_))
  {
    knot_energy[n_side] = 0.;
    for (int k = 1; k <= n_side; ++k)
      {
        knot_energy[n_side + k] = knot_energy[n_side + k - 1] + fine(k - 1, k);
        knot_energy[n_side - k] = knot_energy[n_side - k + 1] + fine(1 - k, -k);
      }
  }

  double force(const double lambda) const { return scale * unit_force(lambda); }

  /// dF/dlambda, N.
  double derivative(const double lambda) const
  {
    double slope;
    unit_force(lambda, slope);
    return scale * slope;
  }

  /// Both at once, for Hessians.
  double force(const double lambda, double &derivative_) const
  {
    const double f = unit_force(lambda, derivative_);
    derivative_ *= scale;
    return scale * f;
  }

  /// Energy per reference length, J/m; infinite for lambda <= 0.
  double energy(const double lambda) const
  {
    if (!(lambda > 0.))
      return HUGE_VAL;
    int k = static_cast<int>(std::lround(panels_per_unit * std::log(lambda)));
    if (k > n_side)
      k = n_side;
    else if (k < -n_side)
      k = -n_side;
    double w = knot_energy[n_side + k], from = knot(k);
    // Beyond the table only: walk in panels of the same ratio.
    for (; lambda > 1.04 * from; from *= 1.04)
      w += panel(from, 1.04 * from);
    for (; lambda < from / 1.04; from /= 1.04)
      w += panel(from, from / 1.04);
    return scale * (w + panel(from, lambda));
  }

  /// The stretch at which the wall carries `tension` (N).
  double stretch_at(const double tension) const
  {
    double lambda = 1.;
    for (int i = 0; i < 100; ++i)
      {
        double slope;
        const double residual = unit_force(lambda, slope) - tension / scale;
        double next = lambda - residual / slope;
        if (!(next > 0.5 * lambda))
          next = 0.5 * lambda;
        const bool done = std::abs(next - lambda) <= 1e-15 * lambda;
        lambda = next;
        if (done)
          break;
      }
    return lambda;
  }

private:
  static constexpr int n_side = 48;
  static constexpr double panels_per_unit = 16.;

  double unit_force(const double lambda) const
  {
    const double r2 = 1. / (lambda * lambda), s = r2 * r2 * r2;
    return lambda - 2. * lambda * s / (beta + std::sqrt(beta_squared + four_rest * s));
  }

  double unit_force(const double lambda, double &slope) const
  {
    const double r2 = 1. / (lambda * lambda), s = r2 * r2 * r2;
    const double R = std::sqrt(beta_squared + four_rest * s);
    const double q = 2. * s / (beta + R);
    slope = 1. - q + 6. * s / R;
    return lambda * (1. - q);
  }

  static double knot(const double k) { return std::exp(k / panels_per_unit); }

  // Between knots a and b in four panels, so that the table itself adds no error.
  double fine(const int a, const int b) const
  {
    double sum = 0.;
    for (int i = 0; i < 4; ++i)
      sum += panel(knot(a + 0.25 * i * (b - a)), knot(a + 0.25 * (i + 1) * (b - a)));
    return sum;
  }

  double panel(const double a, const double b) const
  {
    constexpr double x[2] = {0.33998104358485626480, 0.86113631159405257522};
    constexpr double w[2] = {0.65214515486254614263, 0.34785484513745385737};
    const double c = 0.5 * (a + b), h = 0.5 * (b - a);
    double sum = 0.;
    for (int i = 0; i < 2; ++i)
      sum += w[i] * (unit_force(c - h * x[i]) + unit_force(c + h * x[i]));
    return h * sum;
  }

  double scale, beta, beta_squared, four_rest;
  std::array<double, 2 * n_side + 1> knot_energy;
};
} // namespace turgor
