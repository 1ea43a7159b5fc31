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
// With yielding (wall_yield.h) the force is g(lambda) F(lambda), reversible. Its energy above lambda = 1 is
// integrated over u, lambda = 1 + sinh(u)/A, which moves the singularities of atan to u = +- i pi/2 whatever
// A: panels of 1/8, error 50^-8.
//
// In: lambda = length / rest length (no unit, > 0). Out: F, dF in N (positive in tension), w in J/m.
#pragma once

#include "run/number_text.h"
#include "micro/laws/wall_yield.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace turgor {
class NeoHookeanWall {
 public:
  /// wall_stiffness = G t0 (N/m), depth = z0 (m), beta = axial over hoop stress in [0, 1].
  NeoHookeanWall(const double wall_stiffness, const double depth, const double beta_,
                 const WallYield &yield_ = {})
      : yield(yield_),
        scale(wall_stiffness * depth),
        beta(beta_),
        beta_squared(beta_ * beta_),
        four_rest(4. * (1. - beta_)) {
    knot_energy[n_side] = 0.;
    for (int k = 1; k <= n_side; ++k) {
      knot_energy[n_side + k] = knot_energy[n_side + k - 1] + fine(k - 1, k);
      knot_energy[n_side - k] = knot_energy[n_side - k + 1] + fine(1 - k, -k);
    }
  }

  double force(const double lambda) const {
    const double f = scale * unit_force(lambda);
    return yield.active() ? f * yield.share(lambda) : f;
  }

  /// dF/dlambda, N.
  double derivative(const double lambda) const {
    double slope;
    force(lambda, slope);
    return slope;
  }

  /// Both at once, for Hessians.
  double force(const double lambda, double &derivative_) const {
    const double f = scale * unit_force(lambda, derivative_);
    derivative_ *= scale;
    if (!yield.active()) return f;
    const double g = yield.share(lambda);
    derivative_ = g * derivative_ + yield.derivative(lambda) * f;
    return g * f;
  }

  /// Both of many edges: the same bits, several at once.
  void forces(const std::size_t count, const double *__restrict lambda, double *__restrict f,
              double *__restrict slope) const {
    for (std::size_t i = 0; i < count; ++i) {
      f[i] = scale * unit_force(lambda[i], slope[i]);
      slope[i] *= scale;
    }
    if (yield.active())
      for (std::size_t i = 0; i < count; ++i) {
        const double g = yield.share(lambda[i]);
        slope[i] = g * slope[i] + yield.derivative(lambda[i]) * f[i];
        f[i] *= g;
      }
  }

  const WallYield &yielding() const { return yield; }

  /// The same wall without yielding.
  NeoHookeanWall elastic() const {
    NeoHookeanWall wall = *this;
    wall.yield = {};
    return wall;
  }

  /// Energy per reference length, J/m; infinite for lambda <= 0.
  double energy(const double lambda) const {
    if (!(lambda > 0.)) return HUGE_VAL;
    if (yield.active() && lambda > 1.) return yielding_energy(lambda);
    const int k = knots().nearest(lambda, 0);
    double w = knot_energy[n_side + k], from = knots().at[n_side + k];
    // Beyond the table only: walk in panels of the same ratio.
    for (; lambda > 1.04 * from; from *= 1.04) w += panel(from, 1.04 * from);
    for (; lambda < from / 1.04; from /= 1.04) w += panel(from, from / 1.04);
    return scale * (w + panel(from, lambda));
  }

  /// energy() of many edges: the same bits, several at once where the table reaches.
  void energies(const std::size_t count, const double *__restrict lambda, double *__restrict w) const {
    constexpr std::size_t most = 64;
    double from[most], base[most];
    const Knots &table = knots();
    for (std::size_t first = 0; first < count; first += most) {
      const std::size_t n = std::min(most, count - first);
      const auto by_table = [&](const double at) {
        return at > table.least() && at < table.largest() && !(yield.active() && at > 1.);
      };
      bool all = true;
      for (std::size_t i = 0, k = n_side; i < n; ++i) {
        k = static_cast<std::size_t>(n_side + table.nearest(lambda[first + i], static_cast<int>(k) - n_side));
        from[i] = table.at[k];
        base[i] = knot_energy[k];
        all = all && by_table(lambda[first + i]);
      }
      for (std::size_t i = 0; i < n; ++i)
        w[first + i] = scale * (base[i] + panel(from[i], lambda[first + i]));
      for (std::size_t i = 0; i < n && !all; ++i)
        if (!by_table(lambda[first + i])) w[first + i] = energy(lambda[first + i]);
    }
  }

  /// The stretch at which the wall carries `tension` (N); with yielding the first one above 1. Throws
  /// std::invalid_argument where a yielding wall gives way before it carries that much.
  double stretch_at(const double tension) const {
    if (yield.active() && tension > 0.) return yielding_stretch_at(tension);
    double lambda = 1.;
    for (int i = 0; i < 100; ++i) {
      double slope;
      const double residual = unit_force(lambda, slope) - tension / scale;
      double next = lambda - residual / slope;
      if (!(next > 0.5 * lambda)) next = 0.5 * lambda;
      const bool done = std::abs(next - lambda) <= 1e-15 * lambda;
      lambda = next;
      if (done) break;
    }
    return lambda;
  }

 private:
  static constexpr int n_side = 48;
  static constexpr double panels_per_unit = 16.;

  double unit_force(const double lambda) const {
    const double r2 = 1. / (lambda * lambda), s = r2 * r2 * r2;
    return lambda - 2. * lambda * s / (beta + std::sqrt(beta_squared + four_rest * s));
  }

  double unit_force(const double lambda, double &slope) const {
    const double r2 = 1. / (lambda * lambda), s = r2 * r2 * r2;
    const double R = std::sqrt(beta_squared + four_rest * s);
    const double q = 2. * s / (beta + R);
    slope = 1. - q + 6. * s / R;
    return lambda * (1. - q);
  }

  double yielding_energy(const double lambda) const {
    const double end = std::asinh(yield.sharpness * (lambda - 1.));
    const int panels = std::max(1, static_cast<int>(std::ceil(8. * end)));
    double sum = 0.;
    for (int i = 0; i < panels; ++i)
      sum += gauss(end * i / panels, end * (i + 1) / panels, [this](const double u) {
        return force(1. + std::sinh(u) / yield.sharpness) * std::cosh(u) / yield.sharpness;
      });
    return sum;
  }

  // The force may fall again after a maximum: climb from lambda = 1 until it is passed, then halve the
  // interval.
  double yielding_stretch_at(const double tension) const {
    double below = 1., above = 1.;
    const double step = std::min(0.05, 0.1 / yield.sharpness);
    double farthest = 0.;  // of what the wall carries on the way up
    while (force(above) < tension) {
      farthest = std::max(farthest, force(above));
      below = above;
      above += std::max(step, 0.05 * (above - 1.));
      if (above > 100.)
        throw std::invalid_argument(
            "Yield sharpness = " + number_text(yield.sharpness) +
            " and Yield drop = " + number_text(yield.drop) + " give a wall that carries at most " +
            number_text(farthest * 1e3) + " mN, less than the " + number_text(tension * 1e3) +
            " mN that Turgor asks of it: take a smaller Yield drop, less Turgor or a larger Wall stiffness.");
    }
    for (int i = 0; i < 200 && above > std::nextafter(below, above); ++i) {
      const double middle = 0.5 * (below + above);
      (force(middle) < tension ? below : above) = middle;
    }
    return above;
  }

  static double knot(const double k) { return std::exp(k / panels_per_unit); }

  /// The same for all walls: stretch at the knots, and where one is nearer than the one before.
  struct Knots {
    double at[2 * n_side + 1], border[2 * n_side + 2];
    Knots() {
      for (int k = -n_side; k <= n_side; ++k) at[n_side + k] = knot(k);
      for (int k = -n_side; k <= n_side + 1; ++k) border[n_side + k] = knot(k - 0.5);
    }
    double least() const { return border[0]; }
    double largest() const { return border[2 * n_side + 1]; }
    /// In -n_side ... n_side, found from k: one step and less where neighbours are stretched alike.
    int nearest(const double lambda, int k) const {
      while (k < n_side && lambda >= border[n_side + k + 1]) ++k;
      while (k > -n_side && lambda < border[n_side + k]) --k;
      return k;
    }
  };
  static const Knots &knots() {
    static const Knots table;
    return table;
  }

  // Between knots a and b in four panels, so that the table itself adds no error.
  double fine(const int a, const int b) const {
    double sum = 0.;
    for (int i = 0; i < 4; ++i)
      sum += panel(knot(a + 0.25 * i * (b - a)), knot(a + 0.25 * (i + 1) * (b - a)));
    return sum;
  }

  double panel(const double a, const double b) const {
    return gauss(a, b, [this](const double lambda) { return unit_force(lambda); });
  }

  template <class Function>
  static double gauss(const double a, const double b, const Function &function) {
    constexpr double x[2] = {0.33998104358485626480, 0.86113631159405257522};
    constexpr double w[2] = {0.65214515486254614263, 0.34785484513745385737};
    const double c = 0.5 * (a + b), h = 0.5 * (b - a);
    double sum = 0.;
    for (int i = 0; i < 2; ++i) sum += w[i] * (function(c - h * x[i]) + function(c + h * x[i]));
    return h * sum;
  }

  WallYield yield;
  double scale, beta, beta_squared, four_rest;
  std::array<double, 2 * n_side + 1> knot_energy;
};
}  // namespace turgor
