#include "app/first_swing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace turgor {
namespace {
/// Vertex of the parabola through three samples whose middle one is an extremum; the sample itself at the
/// ends.
std::pair<double, double> vertex(const std::vector<double> &t, const std::vector<double> &u,
                                 const std::size_t i) {
  if (i == 0 || i + 1 == t.size()) return {t[i], u[i]};
  const double a = t[i - 1] - t[i], b = t[i + 1] - t[i];
  const double slope_a = (u[i - 1] - u[i]) / a, slope_b = (u[i + 1] - u[i]) / b;
  const double bend = (slope_b - slope_a) / (b - a), slope = slope_a - bend * a;
  if (bend == 0.) return {t[i], u[i]};
  const double s = -0.5 * slope / bend;
  return {t[i] + s, u[i] + 0.5 * slope * s};
}
}  // namespace

Swing first_swing(const std::vector<double> &t, const std::vector<double> &moving) {
  double size = 0.;
  for (const double value : moving) size = std::max(size, std::abs(value));
  if (t.size() < 3 || !(size > 0.))
    throw std::runtime_error(t.size() < 3 ? "There is no swing: too few rows."
                                          : "There is no swing: nothing moves.");
  // Out until it has come half the way back: a later swing may be larger by a hair.
  std::size_t largest = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (std::abs(moving[i]) > std::abs(moving[largest]))
      largest = i;
    else if (std::abs(moving[i]) < 0.5 * std::abs(moving[largest]) && std::abs(moving[largest]) > 0.5 * size)
      break;
  Swing swing;
  std::tie(swing.time_of_largest, swing.amplitude) = vertex(t, moving, largest);
  const double sign = swing.amplitude > 0. ? 1. : -1.;
  std::size_t back = largest;
  for (std::size_t i = largest; i < t.size(); ++i)
    if (sign * moving[i] < sign * moving[back])
      back = i;
    else if (sign * (moving[i] - moving[back]) > 0.05 * std::abs(swing.amplitude) &&
             sign * moving[back] < 0.5 * std::abs(swing.amplitude))
      break;  // on its second way out
  if (back > largest && back + 1 < t.size()) swing.period = vertex(t, moving, back).first;
  return swing;
}
}  // namespace turgor
