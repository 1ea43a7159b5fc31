#include "micro/scenes/deformable/growing_measures.h"
#include "micro/scenes/deformable/spheroid_deformable.h"

namespace turgor {
Outputs SpheroidDeformable::outputs() const {
  const std::vector<OutputDefinition> columns = columns_of_growing_cells();
  const char *divided = "where cells have divided";
  Outputs all =
      outputs_of_cells("One row at the start, then spread evenly over time, and one at the end.", columns);
  all.results(columns);
  all.results(
      {{"time", "s", "Simulated time at the end of the run."},
       {"divisions", "", "Number of divisions since the start of the run."},
       {"doubling_time_closed_form", "s",
        "Time in which exponential growth doubles the number of cells, from the mean and the spread of the "
        "cycle time."},
       {"cells_closed_form", "",
        "Number of cells that is expected without inhibition: of newborn ones by the distribution of their "
        "cycle "
        "times, of ages that are spread by that doubling time."},
       {"cells_deviation", "1", "How far the number of cells is from its closed form, relative."},
       {"division_cpu_time", "s",
        "CPU time that a division takes, mean since the run was started last: laying daughters and their "
        "coming to "
        "rest.",
        "where cells have divided since"},
       {"division_steps", "", "Number of steps in which the daughters of a division come to rest, mean.",
        divided},
       {"division_rejected_steps", "",
        "Number of those steps that were repeated with a shorter length, of all "
        "divisions.",
        divided},
       {"division_least_volume", "1",
        "Least volume of any daughter over its volume without pressure, after those steps, over that of the "
        "mother.",
        divided},
       {"division_least_angle", "rad", "Least angle of any triangle of a daughter after those steps.",
        divided},
       {"division_lowest_gap", "m",
        "Smallest distance of a daughter's surface to another one after those steps, at 16 places of each "
        "triangle, negative where one is inside the other.",
        divided}});
  return all.join(outputs_of_profile());
}
}  // namespace turgor
