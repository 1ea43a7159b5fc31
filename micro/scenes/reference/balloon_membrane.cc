// The membranes of the balloon model: tensions, their slopes and the energy at two stretches (balloon_model.h
// has the equations).
#include "micro/scenes/reference/balloon_model.h"

#include <array>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;

/// Integral of g(l) (l - l^-5) from 1 to l: Gauss's rule on 4 parts, g having its bend within a few 1/A of 1.
double yielding_energy(const WallYield &yield, const double l) {
  constexpr double x[3] = {-0.7745966692414834, 0., 0.7745966692414834},
                   weight[3] = {5. / 9., 8. / 9., 5. / 9.};
  double sum = 0.;
  for (int part = 0; part < 4; ++part)
    for (int k = 0; k < 3; ++k) {
      const double at = 1. + (l - 1.) * (part + 0.5 + 0.5 * x[k]) / 4.;
      sum += weight[k] * yield.share(at) * (at - std::pow(at, -5.));
    }
  return sum * (l - 1.) / 8.;
}
}  // namespace

BalloonModel::Tension BalloonModel::tension(const double a, const double b) const {
  Tension T;
  if (membrane == Membrane::neo_hookean) {
    const double j3 = 1. / (a * a * a * b * b * b);
    T.t1 = wall_stiffness * (a / b - j3);
    T.t2 = wall_stiffness * (b / a - j3);
    T.t1_by_1 = wall_stiffness * (1. / b + 3. * j3 / a);
    T.t1_by_2 = wall_stiffness * (-a / (b * b) + 3. * j3 / b);
    T.w = 0.5 * wall_stiffness * (a * a + b * b + 1. / (a * a * b * b) - 3.);
    return T;
  }
  // h = f/l with f = l - l^-5 is 1 - l^-6, times what yielding leaves; the mean over directions by the
  // midpoint rule, which is exact to round-off for such smooth periodic functions.
  static const auto squares = [] {
    std::array<double, 12> c2{};
    for (std::size_t k = 0; k < c2.size(); ++k)
      c2[k] = std::pow(std::cos((double(k) + 0.5) * 0.5 * pi / double(c2.size())), 2);
    return c2;
  }();
  double hc = 0., hs = 0., slope_cc = 0., slope_cs = 0., w = 0.;
  for (const double c2 : squares) {
    const double s2 = 1. - c2, q = 1. / (a * a * c2 + b * b * s2), q3 = q * q * q;
    double h = 1. - q3, slope = 6. * q3 * q;  // slope: dh/dl / l
    if (yield.active()) {
      const double l = 1. / std::sqrt(q), g = yield.share(l);
      slope = slope * g + h * yield.derivative(l) / l;
      h *= g;
      w += yielding_energy(yield, l);
    } else
      w += 0.5 / q + 0.25 * q * q - 0.75;
    hc += h * c2;
    hs += h * s2;
    slope_cc += slope * c2 * c2;
    slope_cs += slope * c2 * s2;
  }
  const double scale = 2. * wall_stiffness / double(squares.size());
  T.t1 = scale * a / b * hc;
  T.t2 = scale * b / a * hs;
  T.t1_by_1 = scale / b * (hc + a * a * slope_cc);
  T.t1_by_2 = -T.t1 / b + scale * a * slope_cs;
  T.w = scale * w;
  return T;
}
}  // namespace turgor
