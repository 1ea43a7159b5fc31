#include "micro/scenes/spheroid/spheroid_run.h"

#include "micro/geometry/compact_cluster.h"
#include "micro/scenes/shared_entries.h"
#include "run/entry_marks.h"
#include "run/input_entries.h"
#include "run/number_text.h"

#include <cmath>

namespace turgor {
void SpheroidScene::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("First cells", first_cells, "Number of cells in the cluster at the start. Units: none.",
                    Integer(1, 10000000));
  prm.add_parameter("First phases", phases,
                    "Phases of the first cells in their cycle: synchronous (all newborn) or spread (ages of "
                    "exponential growth). Units: none.");
  prm.add_parameter(
      "End time", duration,
      end_of_run("Simulated time after which the run ends, unless something else ends it before. Units: s."),
      Double(0., 1e12));
  prm.rename("Duration", "End time");
  prm.add_parameter(
      "Most cells", most_cells,
      "The run ends when there are so many cells, if that is before End time; 0: no limit. Units: none.",
      Double(0., 1e9));
  prm.add_parameter("Samples", samples,
                    end_of_run("Number of equal parts of End time after each of which growth.csv gets a row; "
                               "a run that ends before it has fewer. Units: none."),
                    Integer(10, 1000000));
  prm.add_parameter("Frames", frames,
                    free_to_change("Number of equal parts of End time after each of which the cells are "
                                   "written for ParaView and pictures; 0: never. Units: none."),
                    Integer(0, 100000));
  declare_checkpoints(prm, checkpoints);
  entries.declare(prm);
  declare_more(prm);
}

void SpheroidScene::check() const {
  entries.check();
  if (most_cells > 0. && most_cells <= double(first_cells))
    throw InputError("Most cells is " + number_text(most_cells) + ", but the run begins with First cells = " +
                     number_text(first_cells) + ": it has to be larger, or 0 for no limit.");
  check_more();
  CellCulture(culture_parameters(), make_surroundings(),
              1);  // what the laws refuse a run would refuse only once it has begun
}

double SpheroidScene::first_phase(const std::size_t i) const {
  return phase_at_start(phases, std::uint64_t(entries.seed), i);
}

double SpheroidScene::largest_first_radius() const {
  return entries.numbers.life.birth_radius * (phases == FirstPhases::spread ? std::cbrt(2.) : 1.);
}

double SpheroidScene::first_spacing() const {
  return 1.8 * entries.numbers.life.birth_radius * (phases == FirstPhases::spread ? std::cbrt(2.) : 1.);
}

void SpheroidScene::seed(CellCulture &culture) const {
  std::size_t i = 0;
  for (const Vector<3> &x : compact_cluster(first_cells, first_spacing(), flat))
    culture.life.add(culture.cells, x, first_phase(i++));
}

void SpheroidScene::run(RunContext &context) { Run(*this, context).go(); }
}  // namespace turgor
