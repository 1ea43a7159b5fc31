#include "app/swing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace turgor
{
namespace
{
/// Vertex of the parabola through three samples whose middle one is an extremum; the sample itself at the ends.
std::pair<double, double> vertex(const std::vector<double> &t, const std::vector<double> &u, const std::size_t i)
{
  if (i == 0 || i + 1 == t.size())
    return {t[i], u[i]};
  const double a = t[i - 1] - t[i], b = t[i + 1] - t[i];
  const double slope_a = (u[i - 1] - u[i]) / a, slope_b = (u[i + 1] - u[i]) / b;
  const double bend = (slope_b - slope_a) / (b - a), slope = slope_a - bend * a;
  if (bend == 0.)
    return {t[i], u[i]};
  const double s = -0.5 * slope / bend;
  return {t[i] + s, u[i] + 0.5 * slope * s};
}
} // namespace

Swing first_swing(const CsvTable &probe)
{
  const auto &t = probe.column("time");
  const auto &x = probe.column("displacement_x"), &y = probe.column("displacement_y");
  const auto size = [](const std::vector<double> &u) {
    double most = 0.;
    for (const double value : u)
      most = std::max(most, std::abs(value));
    return most;
  };
  const std::vector<double> &moving = size(x) > size(y) ? x : y;
  if (t.size() < 3 || !(size(moving) > 0.))
    throw std::runtime_error(probe.file.string() + " has no swing: " + (t.size() < 3 ? "too few rows." : "nothing moves."));
  // Out until it has come half the way back: a later swing may be larger by a hair.
  std::size_t largest = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (std::abs(moving[i]) > std::abs(moving[largest]))
      largest = i;
    else if (std::abs(moving[i]) < 0.5 * std::abs(moving[largest]) && std::abs(moving[largest]) > 0.5 * size(moving))
      break;
  Swing swing;
  std::tie(swing.time_of_largest, swing.amplitude) = vertex(t, moving, largest);
  const double sign = swing.amplitude > 0. ? 1. : -1.;
  std::size_t back = largest;
  for (std::size_t i = largest; i < t.size(); ++i)
    if (sign * moving[i] < sign * moving[back])
      back = i;
    else if (sign * (moving[i] - moving[back]) > 0.05 * std::abs(swing.amplitude)
             && sign * moving[back] < 0.5 * std::abs(swing.amplitude))
      break; // on its second way out
  if (back > largest && back + 1 < t.size())
    swing.period = vertex(t, moving, back).first;
  return swing;
}
} // namespace turgor
