#include "micro/scenes/deformable/spheroid_deformable.h"

#include "micro/geometry/compact_cluster.h"
#include "micro/laws/population_doubling.h"
#include "micro/scenes/deformable/growing_measures.h"
#include "micro/scenes/life_entries.h"
#include "run/entry_marks.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void SpheroidDeformable::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("First cells", first_cells,
                    "Number of cells at the start, a compact cluster. Units: none.", Integer(1, 10000));
  prm.add_parameter("First phases", first_phases,
                    "Phases of the first cells in their cycle: synchronous (all newborn) or spread (ages of "
                    "exponential growth). Units: none.");
  prm.add_parameter("End time", end,
                    "Simulated time after which the run ends, unless Most cells ends it before. Units: s.",
                    Double(1., 1e12));
  prm.add_parameter(
      "Most cells", most_cells,
      "The run ends when there are so many cells, if that is before End time; 0: no limit. Units: none.",
      Double(0., 1e9));
  prm.add_parameter(
      "Frames", frames,
      "Number of equal parts of End time after each of which the surfaces are written, with Fields "
      "= true. Units: none.",
      Integer(1, 10000));
  prm.add_parameter("Seed", seed,
                    "Seed of all that is drawn at random: nets, cycle times, directions. Units: none.",
                    Integer(0, 1000000));
  declare_cells(prm, material, output, true);
  prm.enter_subsection("Cell");
  prm.add_parameter("Cycle time", cycle_time,
                    "Mean time T from birth to division of uncompressed cells, mitosis included. Units: s.",
                    Double(1., 1e12));
  prm.add_parameter("Variability", spread,
                    "Standard deviation of the cycle time over its mean, clamped at 4 of them. Units: none.",
                    Double(0., 0.24));
  prm.leave_subsection();
  prm.enter_subsection("Growth");
  declare_growth(prm, growth, cycle);
  prm.leave_subsection();
  prm.enter_subsection("Division");
  declare_direction(prm, division, axis);
  prm.leave_subsection();
}

void SpheroidDeformable::check() const {
  material.check_contact();
  check_mitosis(cycle, cycle_time);
  check_direction(division, axis);
  if (material.longest_step > 0.02 * cycle_time)
    throw InputError("Longest step is " + number_text(material.longest_step) +
                     " s, but cells are looked at once a step: it has to be at most a fiftieth of Cell/Cycle "
                     "time (" +
                     number_text(cycle_time) + " s).");
  if (most_cells > 0. && most_cells <= double(first_cells))
    throw InputError("Most cells is " + number_text(most_cells) + ", but the run begins with First cells = " +
                     number_text(first_cells) + ": it has to be larger, or 0 for no limit.");
}

GrowingCellsParameters SpheroidDeformable::parameters() const {
  GrowingCellsParameters all;
  all.material = material;
  all.life = {.birth_volume = 4. / 3. * std::numbers::pi * std::pow(material.radius, 3),
              .cycle_time = cycle_time,
              .growth = growth,
              .cycle = cycle,
              .variability = {.spread = spread, .clamp = 4., .seed = seed}};
  all.division = division;
  all.division.axis = division_axis(axis);
  all.division.seed = seed;
  all.interval = material.longest_step;
  return all;
}

std::vector<double> SpheroidDeformable::phases() const {
  std::vector<double> all;
  for (std::uint64_t i = 0; i < first_cells; ++i) all.push_back(phase_at_start(first_phases, seed, i));
  return all;
}

std::vector<Vector<3>> SpheroidDeformable::places() const {
  const double largest = material.radius * (first_phases == FirstPhases::spread ? std::cbrt(2.) : 1.);
  return compact_cluster(first_cells, 2. * largest + material.rest, false);
}

void SpheroidDeformable::run(RunContext &context) {
  GrowingCells tissue(parameters(), places(), phases(), context.threads());
  tissue.begin();
  std::vector<double> stops;
  for (unsigned int k = 1; k <= frames; ++k) stops.push_back(end * double(k) / frames);
  const std::vector<OutputDefinition> columns = columns_of_growing_cells();
  CellsRun run(context, tissue.cells,
               {.stops = stops,
                .output = output,
                .columns = columns,
                .row = [&] { return measured(tissue); },
                .doing = "growing",
                .advice = "A larger Longest step or Tolerance lengthens them.",
                .reach = 1.,
                .step = [&](const double limit) { tissue.step(limit); },
                .population = [&](Archive &a) { tissue.archive_population(a); },
                .full = [&] { return most_cells > 0. && double(tissue.size()) >= most_cells; }});
  run.go();
  const std::vector<double> row = measured(tissue);
  for (std::size_t k = 0; k < columns.size(); ++k) context.result(columns[k].name, row[k], columns[k].unit);
  report(context, tissue, row);
  write_profile(context, tissue);
  report_cells(context, tissue.cells, material, run.steps());
}

void SpheroidDeformable::report(RunContext &context, const GrowingCells &tissue,
                                const std::vector<double> &row) const {
  const double doubling = doubling_time(cycle_time, spread), t = tissue.cells.time(),
               expected = double(first_cells) * (first_phases == FirstPhases::spread
                                                     ? std::exp2(t / doubling)
                                                     : expected_cells(t, cycle_time, spread));
  context.result("time", t, "s");
  context.result("divisions", double(tissue.life.divisions), "");
  context.result("doubling_time_closed_form", doubling, "s");
  context.result("cells_closed_form", expected, "");
  context.result("cells_deviation", row[0] / expected - 1., "1");
  if (tissue.life.divisions == 0) return;
  const GrowingCells::Divisions &divided = tissue.divided;
  if (tissue.timed > 0) context.result("division_cpu_time", tissue.dividing / double(tissue.timed), "s");
  context.result("division_steps", double(divided.steps) / double(tissue.life.divisions), "");
  context.result("division_rejected_steps", double(divided.rejected), "");
  context.result("division_least_volume", divided.least_volume, "1");
  context.result("division_least_angle", divided.least_angle, "rad");
  context.result("division_lowest_gap", std::min(divided.lowest_gap, material.rest), "m");
}

std::unique_ptr<Scenario> make_spheroid_deformable() { return std::make_unique<SpheroidDeformable>(); }
}  // namespace turgor
