#include "micro/scenes/spheroid/spheroid_relaxation.h"

#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <cmath>

namespace turgor {
SpheroidRelaxation::SpheroidRelaxation() {
  first_cells = 300;
  phases = FirstPhases::spread;
  duration = 86400.;
  samples = 400;
  frames = 4;
}

void SpheroidRelaxation::declare_more(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Compressed size", size,
                    "Size of the spheroid before it is let go, over its size at rest: all places are drawn "
                    "together by that factor. Units: none.",
                    Double(0.5, 0.999));
  prm.add_parameter(
      "Settling time", settling,
      "Simulated time in which the first cluster comes to rest before it is compressed. Units: s.",
      Double(0., 1e12));
}

void SpheroidRelaxation::check_more() const {
  if (first_cells < 2)
    throw InputError("First cells is " + number_text(first_cells) +
                     ", but a spheroid that can be compressed has at least 2.");
}

CultureParameters SpheroidRelaxation::culture_parameters() const {
  CultureParameters parameters = entries.parameters();
  parameters.life.growth.inhibition = Inhibition::none;
  parameters.life.cycle.restriction = parameters.life.cycle.quiescence_below = 2.;  // all cells rest
  parameters.interval = duration / 400.;
  return parameters;
}

void SpheroidRelaxation::seed(CellCulture &culture) const {
  SpheroidScene::seed(culture);
  while (culture.time() < settling)
    culture.advance(settling, [] {
      stop_here("while the first cluster settled");
      return false;
    });
  CellPopulation &cells = culture.cells;
  Particles<3> &p = cells.particles;
  for (int d = 0; d < 3; ++d) {
    double middle = 0.;
    for (const double x : p.x[d]) middle += x / double(cells.size());
    for (double &x : p.x[d]) x = size * (x - middle);
    std::fill(p.v[d].begin(), p.v[d].end(), 0.);
  }
  // Held: every strain is that at rest under its cell's pressure, which it changes; half-way steps to the
  // fixed point.
  std::vector<double> &eps = p.cells.column("strain"), &R = p.field("radius");
  const std::vector<double> &K = p.cells.column("bulk_modulus"), &V_ref = p.field("reference_volume");
  double change = 1.;
  for (int k = 0; k < 500 && change > 1e-8; ++k) {
    stop_here("while the compressed spheroid was laid out");
    const std::vector<double> &pressure = culture.pressures();
    change = 0.;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double step = 0.5 * (entries.numbers.life.volume.strain_at_rest(pressure[i], K[i]) - eps[i]);
      eps[i] += step;
      R[i] = sphere_radius(compressed_volume(V_ref[i], eps[i]));
      change = std::max(change, std::abs(step));
    }
  }
  culture.restart_clock();
}

void SpheroidRelaxation::report(RunContext &context, const GrowthTable &table, CellCulture &) const {
  const std::vector<double> time = table.column("time"), radius = table.column("gyration_radius");
  const double start = radius.front(), end = radius.back(), level = end - (end - start) * std::exp(-1.);
  context.result("gyration_radius_compressed", start, "m");
  context.result("gyration_radius_at_rest", end, "m");
  if (!(end > start))
    return context.note(
        "relaxation_time",
        "None: the spheroid did not grow when it was let go. It was compressed by less than it still settled"
        " (Compressed size, Settling time).");
  for (std::size_t k = 1; k < time.size(); ++k)
    if (radius[k] >= level) {
      const double share = (level - radius[k - 1]) / (radius[k] - radius[k - 1]);
      const double found = time[k - 1] + share * (time[k] - time[k - 1]);
      context.result("relaxation_time", found, "s");
      context.result("relaxation_time_over_that_of_a_cell",
                     found / std::max(entries.numbers.life.relaxation, 1.), "1");
      break;
    }
}

std::unique_ptr<Scenario> make_spheroid_relaxation() { return std::make_unique<SpheroidRelaxation>(); }
}  // namespace turgor
