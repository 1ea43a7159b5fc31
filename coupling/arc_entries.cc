// What a user says to run_arc() and what it leaves.
#include "coupling/arc_run.h"
#include "run/input_entries.h"
#include "run/output_list.h"

namespace turgor {
void ArcRunSettings::declare(InputEntries &prm) {
  prm.enter_subsection("Arc length");
  prm.add_parameter("First share", first_share,
                    "Share of the loads that the first step along the path aims at. Units: 1.",
                    Patterns::Double(1e-6, 1.));
  prm.add_parameter(
      "Longest", longest,
      "Longest step along the path: root mean square of the displacement in it, over the width. "
      "Units: 1.",
      Patterns::Double(1e-6, 1.));
  prm.add_parameter(
      "Furthest", furthest,
      "Mean displacement of the side x = W, in any direction and over the width, at which the run "
      "ends where the loads are not all on before. Units: 1.",
      Patterns::Double(1e-6, 1e3));
  prm.add_parameter("Most steps", most_steps, "Steps along the path after which the run ends. Units: 1.",
                    Patterns::Integer(1, 1000000));
  prm.leave_subsection();
}

void ArcRunSettings::check(const TissueParameters<2> &tissue) const {
  if (tissue.tool.active() || tissue.left == LeftSide::plate)
    throw InputError(
        "'Loads/Way = arc_length' follows loads that may fall again, not a tool or a plate, whose way is "
        "given: "
        "take 'Way = steps' for them, or 'Tool = none' with 'Support = clamped'.");
  if (!(tissue.body_force.norm() > 0.) && !(tissue.traction.norm() > 0.))
    throw InputError(
        "'Loads/Way = arc_length' needs a load to follow: a Tissue statics/Load or a Loads/Traction that is "
        "not "
        "0.");
}

Outputs arc_run_outputs() {
  const char *const limit = "where the load falls on the way";
  Outputs all;
  all.results(
         {{"load_share_reached", "1", "Share of the loads that is on at the end of the path."},
          {"path_displacement_x", "m", "Displacement along x of the side x = W at the end, its mean."},
          {"path_displacement_y", "m", "Displacement along y of the side x = W at the end, its mean."},
          {"load_share_at_limit", "1",
           "Largest share of the loads before it first falls: what the tissue can carry.", limit},
          {"limit_displacement_x", "m", "Displacement along x of the side x = W there, its mean.", limit},
          {"limit_displacement_y", "m", "Displacement along y of the side x = W there, its mean.", limit},
          {"load_share_least_beyond", "1", "Least share of the loads beyond that limit.", limit},
          {"path_energy_gap_share", "1",
           "Work less stored and dissipated energy, each computed on its own, over the largest work so far: "
           "the "
           "error of the steps."},
          {"path_steps", "", "Number of accepted steps along the path."},
          {"path_steps_halved", "", "Number of searches for equilibrium that found none and were halved."},
          {"path_iterations", "", "Number of Newton iterations of the tissue, of halved steps too."},
          {"path_residual_max", "1",
           "Largest norm of the unbalanced nodal forces of an accepted step over that of all nodal forces."},
          {"path_rve_points", "", "Number of quadrature points, each with an RVE of its own."},
          {"path_rve_calls", "", "Number of evaluations of an RVE."},
          {"path_cpu_time", "s", "CPU time of the whole run, all threads and ranks together."}})
      .table("path", "One row for each step along the path, energies per metre of depth.",
             {{"load_share", "1", "Share of tractions and body force that is on; falls beyond a limit."},
              {"side_displacement_x", "m", "Displacement along x of the side x = W, its mean."},
              {"side_displacement_y", "m", "Displacement along y of the side x = W, its mean."},
              {"failed_share", "1", "Share of all cells that have failed."},
              {"mean_permanent_stretch", "1",
               "Permanent stretch by yielding of the walls, mean over the block's area."},
              {"work", "J/m", "Work of the loads since rest; falls where they go back with the tissue."},
              {"stored", "J/m", "Elastic energy of all RVEs less that of the undeformed, turgid state."},
              {"dissipated", "J/m", "Energy that yielding and breaking walls have dissipated since rest."},
              {"gap", "J/m", "Work less these two: the error of the steps."},
              {"residual", "1", "Norm of the unbalanced nodal forces over that of all nodal forces."}});
  return all;
}
}  // namespace turgor
