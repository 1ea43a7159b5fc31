#include "micro/scenes/spheroid/spheroid_free.h"

#include "micro/geometry/compact_cluster.h"
#include "run/run_context.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
/// Over the samples from `from` on (trapezoids).
double time_integral(const std::vector<double> &time, const std::vector<double> &value, const double from) {
  double sum = 0.;
  for (std::size_t k = 1; k < time.size(); ++k)
    if (time[k - 1] >= from) sum += 0.5 * (value[k] + value[k - 1]) * (time[k] - time[k - 1]);
  return sum;
}
}  // namespace

SpheroidFree::SpheroidFree() {
  duration = 9. * 61200.;  // cycles
  samples = 400;
  frames = 9;
  entries.numbers.life.growth.inhibition = Inhibition::none;
  entries.numbers.motion.tolerance = 2e-3;
  entries.numbers.motility = 1e-16;
}

void SpheroidFree::check_more() const {
  body.check({compact_cluster(first_cells, first_spacing(), flat), largest_first_radius(), duration});
}

Surroundings SpheroidFree::make_surroundings() const {
  if (!body.is_there()) return {};
  return body.surroundings(entries.parameters().stiffness);
}

void SpheroidFree::report_body(RunContext &context, const GrowthTable &table) const {
  double square = 0.;
  for (const char *name : {"body_x", "body_y", "body_z"})
    square += std::pow(table.column(name).back() - table.column(name).front(), 2);
  const std::vector<double> imbalance = table.column("body_imbalance");
  context.result("body_travel", std::sqrt(square), "m");
  context.result("body_pressing", table.column("body_pressing").back(), "N");
  context.result("largest_body_imbalance", *std::max_element(imbalance.begin(), imbalance.end()), "1");
}

void SpheroidFree::report(RunContext &context, const GrowthTable &table, CellCulture &culture) const {
  if (has_body()) report_body(context, table);
  const double T = entries.numbers.life.cycle_time, end = culture.time();
  const std::vector<double> time = table.column("time"), cells = table.column("cells"),
                            radius = table.column("radius");
  const double expected = doubling_time(T, entries.numbers.life.variability.spread);
  context.result("doubling_time_closed_form", expected, "s");
  const double whole = std::max(1., std::floor(end / T) - 1.), from = end - whole * T;
  if (from >= 0.) {
    const double rate = fitted_slope(time, cells, from, end, true);
    const std::size_t begin = std::size_t(std::lower_bound(time.begin(), time.end(), from) - time.begin());
    if (rate > 0. &&
        cells.back() >=
            2. * cells[begin])  // else it would be guessed from a part of it, or from nothing but rounding
    {
      context.result("doubling_time", std::numbers::ln2 / rate, "s");
      context.result("doubling_time_error", std::numbers::ln2 / rate / expected - 1., "1");
    }
    double mean = 0., count = 0., worst = 0.;
    for (std::size_t k = 0; k < time.size(); ++k)
      if (time[k] >= from) {
        mean += std::log(cells[k]) - rate * (time[k] - from);
        count += 1.;
      }
    for (std::size_t k = 0; k < time.size(); ++k)
      if (time[k] >= from)
        worst = std::max(worst,
                         std::abs(std::expm1(std::log(cells[k]) - rate * (time[k] - from) - mean / count)));
    context.result("deviation_from_exponential", worst, "1");
  }
  if (entries.numbers.life.death.rim != Rim::none && end > T) {
    const double l = entries.numbers.life.death.rim_thickness, rate = std::numbers::ln2 / expected;
    const double R = 0.5 * (radius.back() + radius[radius.size() / 2]);
    const auto closed_form = [&](const double r) { return l * rate * (1. - l / r + l * l / (3. * r * r)); };
    constexpr double um_per_day = 86400. * 1e6;
    context.result("radial_speed", um_per_day * fitted_slope(time, radius, 0.5 * end, end, false), "um/d");
    if (R > l) context.result("radial_speed_closed_form", um_per_day * closed_form(R), "um/d");
    const auto first = std::size_t(std::lower_bound(time.begin(), time.end(), 0.5 * end) - time.begin());
    if (first + 1 >= time.size()) return;
    if (*std::min_element(radius.begin() + std::ptrdiff_t(first), radius.end()) > l) {
      std::vector<double> speed(radius.size(), 0.);
      std::transform(radius.begin() + std::ptrdiff_t(first), radius.end(),
                     speed.begin() + std::ptrdiff_t(first), closed_form);
      context.result("radial_speed_closed_form_mean",
                     um_per_day * time_integral(time, speed, time[first]) / (time.back() - time[first]),
                     "um/d");
    }
    const std::vector<double> volume = table.column("volume");
    const double growing = time_integral(time, table.column("proliferating_volume"), time[first]);
    if (entries.numbers.life.death.rim == Rim::quiescent && growing > 0.)
      context.result("rim_production_error", (volume.back() - volume[first]) / (rate * growing) - 1., "1");
  }
}

std::unique_ptr<Scenario> make_spheroid_free() { return std::make_unique<SpheroidFree>(); }
}  // namespace turgor
