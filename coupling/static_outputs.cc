#include "coupling/static_run.h"
#include "coupling/tissue_outputs.h"
#include "run/output_list.h"

namespace turgor {
namespace {
const char *const tool = "with a tool", *const torn = "with walls that yield or break";

std::vector<OutputDefinition> curve_results() {
  return {
      {"side_displacement_x", "m", "Displacement along x of the side x = Width at the end, its mean."},
      {"side_displacement_y", "m", "Displacement along y of the side x = Width at the end, its mean."},
      {"failed_share", "1",
       "Share of all cells that have failed at the end; a quadrature point counts with its area.", torn},
      {"mean_permanent_stretch", "1",
       "Permanent stretch by yielding of the walls at the end, mean over the block's area.", torn},
      {"force", "N/m", "Force of the tissue on the tool at the end, per metre of depth.", tool},
      {"travel", "m", "Way that the tool has gone from the first contact to the end.", tool},
      {"peak_force", "N/m", "Largest force of the tissue on the tool, per metre of depth.", tool},
      {"travel_at_peak_force", "m", "Way of the tool at that largest force.", tool},
      {"largest_slope", "N/m^2",
       "Largest slope of force over travel before the bio-yield, between two steps.", tool},
      {"bio_yield_force", "N/m",
       "Force on the tool at the bio-yield: the last step before the first one in which the tool goes on "
       "and the force does not rise.",
       "where the force once does not rise"},
      {"bio_yield_travel", "m", "Way of the tool at the bio-yield.", "where the force once does not rise"},
      {"bio_yield_strain", "1", "That way over the undeformed width of the block.",
       "where the force once does not rise"},
      {"force_at_first_failure", "N/m", "Force on the tool in the last step before the first cell failed.",
       "with a tool, where a cell failed"},
      {"travel_at_first_failure", "m", "Way of the tool in the last step before the first cell failed.",
       "with a tool, where a cell failed"},
      {"penetration_share_max", "1",
       "Largest depth of a point of the surface inside the tool or the support's plate, over the smaller of "
       "an element's thickness and the tool's radius.",
       tool}};
}

std::vector<OutputDefinition> energy_results() {
  return {
      {"work", "J/m", "Work of tool and loads from rest to the end, per metre of depth."},
      {"stored", "J/m",
       "Elastic energy of all RVEs at the end less that of the undeformed, turgid state, per metre of "
       "depth."},
      {"dissipated_by_flow", "J/m", "Energy that yielding walls have dissipated, per metre of depth."},
      {"dissipated_by_failure", "J/m", "Energy that breaking walls have set free, per metre of depth."},
      {"dissipated_by_torn_cells", "J/m",
       "Energy that failed cells have lost after their walls broke, by fluid that leaks out and by torn "
       "walls "
       "that drag holds, per metre of depth."},
      {"released", "J/m",
       "Energy dropped where walls broke or buckled and the tissue fell to the next stable state: work of "
       "the "
       "unbalanced forces on its way, which would have become motion and heat, per metre of depth."},
      {"energy_gap_share", "1",
       "Work less stored, contact, dissipated and released energy, each computed on its own, over the "
       "largest "
       "work so far: the error of the load steps, which falls with their square where nothing breaks."},
      {"viscous_stress_bound", "Pa",
       "Upper bound of the viscous stress, which is left out, at the fastest strain rate of a step in which "
       "nothing broke."}};
}

std::vector<OutputDefinition> cost_results() {
  return {
      {"load_steps", "", "Number of accepted load steps."},
      {"load_steps_halved", "", "Number of searches for equilibrium that found none and were halved."},
      {"load_steps_refused", "",
       "Number of states found in which more cells failed than Load steps/Most failing, and which were "
       "halved."},
      {"jumps", "",
       "Number of steps in which walls broke or no equilibrium was near by, and the tissue fell to the next "
       "stable state."},
      {"newton_iterations", "", "Number of Newton iterations of the tissue, rejected increments included."},
      {"residual_max", "1",
       "Largest norm of the unbalanced nodal forces of an accepted step over the largest of all nodal forces "
       "so far."},
      {"rve_points", "", "Number of quadrature points, each with an RVE of its own."},
      {"rve_calls", "", "Number of evaluations of an RVE."},
      {"rve_calls_failed", "", "Number of evaluations of an RVE that gave no stress."},
      {"rve_calls_dragged", "",
       "Number of evaluations whose torn walls found no equilibrium near by and were held by drag.", torn},
      {"rve_cpu_time", "s", "CPU time inside RVEs, all threads and ranks together."},
      {"linear_cpu_time", "s", "CPU time of the tissue's linear systems."},
      {"cpu_time", "s", "CPU time of the whole run, all threads and ranks together."},
      {"explicit_steps", "",
       "Number of steps that central differences would take over the same time, at the stable step of the "
       "tissue at rest."},
      {"explicit_cpu_time", "s",
       "CPU time that these steps would take in RVEs: one call a point and step, each as long as a call "
       "of this run in the mean."}};
}

std::vector<OutputDefinition> step_columns() {
  return {
      {"time", "s", "Time since the start of the test."},
      {"load_share", "1", "Share of tractions and body force that is on."},
      {"travel", "m", "Way that the tool has gone from the first contact."},
      {"force", "N/m", "Force of the tissue on the tool, positive against its motion."},
      {"support_force", "N/m", "Force of the support on the tissue along x."},
      {"side_displacement_x", "m", "Displacement along x of the side x = Width, its mean."},
      {"side_displacement_y", "m", "Displacement along y of the side x = Width, its mean."},
      {"failed_share", "1", "Share of all cells that have failed."},
      {"mean_permanent_stretch", "1",
       "Permanent stretch by yielding of the walls, mean over the block's area."},
      {"time_step", "s", "Length of the load step."},
      {"newton_iterations", "", "Number of Newton iterations since the row before, of halved steps too."},
      {"residual", "1", "Norm of the unbalanced nodal forces over the largest of all nodal forces so far."}};
}
}  // namespace

Outputs static_run_outputs() {
  Outputs all;
  all.results(curve_results())
      .results(energy_results())
      .results(cost_results())
      .table("steps", "One row for each load step, forces per metre of depth.", step_columns())
      .table("energies", "One row for each load step, all per metre of depth.",
             {{"time", "s", "Time since the start of the test."},
              {"work", "J/m", "Work of tool and loads since rest."},
              {"stored", "J/m", "Elastic energy of all RVEs less that of the undeformed, turgid state."},
              {"contact", "J/m", "Energy in the penalty of tool and support."},
              {"dissipated_by_flow", "J/m", "Energy that yielding walls have dissipated since rest."},
              {"dissipated_by_failure", "J/m", "Energy that breaking walls have set free since rest."},
              {"dissipated_by_torn_cells", "J/m",
               "Energy that failed cells have lost since rest after their walls broke, by leaking fluid and "
               "drag."},
              {"released", "J/m",
               "Energy dropped since rest where the tissue fell to the next stable state: work of the "
               "unbalanced forces on its way."},
              {"gap", "J/m", "Work less all of these, each computed on its own: the error of the steps."}});
  return all.join(outlines_outputs(), "with Outlined RVEs > 0").join(tissue_field_outputs());
}
}  // namespace turgor
