#include "coupling/tissue_outputs.h"
#include "coupling/arc_run.h"

#include "coupling/tissue_bruise.h"
#include "coupling/tissue_gravity.h"
#include "coupling/tissue_statics.h"
#include "micro/scenes/shared_outputs.h"

namespace turgor {
namespace {
const char *const heat = "of RVEs that tell what they turn to heat",
                  *const torn = "with walls that yield or break", *const ranks = "on several ranks",
                  *const skipped = "with Skipping = certified",
                  *const audited = "with Skipping = certified, where an answer was audited",
                  *const bounded = "with Skipping = certified, where 299 answers were audited";

std::vector<OutputDefinition> energy_results() {
  return {{"dissipated", "J/m",
           "Work less kinetic, stored and contact energy at the end, per metre of depth: what is missing in "
           "all. Above the work where turgor's energy was set free (see stored)."},
          {"energy_taken_share", "1",
           "What the RVEs have taken (dissipated and lent energy) over the largest work so far. Above 1: "
           "walls that yielded or broke have set free what turgor had stored in them before; negative: "
           "energy came from nothing."},
          {"heat", "J/m",
           "Energy the RVEs have turned to heat by viscosity, yielding and breaking, per metre of depth; of "
           "turgor's energy too, so that it can be above the work.",
           heat},
          {"energy_unexplained_share", "1",
           "What the RVEs have taken less that heat, over the largest work so far.", heat}};
}

Outputs energy_table() {
  Outputs all;
  all.table(
      "energies", "One row for each step of the tissue, all per metre of depth.",
      {{"time", "s", "Time since the start of the run."},
       {"kinetic", "J/m", "Kinetic energy of the tissue by its nodes' velocities."},
       {"stored", "J/m",
        "Elastic energy of all RVEs less that of the undeformed, turgid state. Negative where walls that "
        "yielded or broke have set free what turgor had stored in them: then dissipated and heat are above "
        "the work."},
       {"contact", "J/m", "Energy in the penalty of tool and support."},
       {"work", "J/m", "Work of body force, tractions and tools since the start."},
       {"dissipated", "J/m",
        "Work less kinetic, stored and contact energy; above the work where turgor's energy was set free."},
       {"lent", "J/m", "Energy that the steps' own error has lent the tissue."},
       {"heat", "J/m",
        "Energy the RVEs have turned to heat by viscosity, yielding and breaking; of turgor's energy too.",
        heat}});
  return all;
}

std::vector<OutputDefinition> call_results() {
  return {
      {"steps", "", "Number of accepted steps of the tissue."},
      {"steps_rejected", "", "Number of steps that were taken back and repeated with a shorter length."},
      {"rve_points", "", "Number of quadrature points, each with an RVE of its own."},
      {"rve_calls", "", "Number of evaluations of an RVE."},
      {"rve_calls_failed", "",
       "Number of evaluations of an RVE that gave no stress; their steps were repeated."},
      {"rve_iterations_mean", "1",
       "Mean number of Newton iterations (bursts: micro steps) of an evaluation."},
      {"rve_iterations_max", "",
       "Largest number of Newton iterations (bursts: micro steps) of an evaluation."},
      {"rve_residual_max", "1",
       "Largest force left unbalanced on a node of an RVE, over turgor times node spacing times depth."},
      {"air_share_least", "1",
       "Smallest share of an RVE's area that was air between its cells; negative by what walls are pressed "
       "into each other.",
       "with Structure/Gap"},
      {"rve_calls_dragged", "",
       "Number of evaluations whose torn walls found no equilibrium near by and were held by drag.", torn},
      {"rve_residual_max_dragged", "1",
       "Largest unbalanced force, drag included, of those evaluations, over turgor times node spacing times "
       "depth.",
       torn},
      {"burst_over_macro_step", "1",
       "Time the cells live in an evaluation over the mean step of the tissue; below 1 their dynamics is "
       "slowed by that factor.",
       "with RVE/Burst length > 0"},
      {"micro_steps_over_full_run", "1",
       "Particle steps of all RVEs over those of a full particle run of this piece with the same micro step.",
       "with RVEs of particles"},
      {"rve_stress_spread_max", "Pa",
       "Largest root mean square of an RVE's stress about its mean over the window of averaging.",
       "with RVEs of particles"},
      {"rve_cpu_time", "s", "CPU time inside RVEs, all threads and ranks together."},
      {"rve_cpu_time_per_call", "s", "CPU time inside RVEs over the number of evaluations."},
      {"rve_calls_per_wall_second", "1/s", "Number of evaluations over the wall time of the run."},
      {"macro_cpu_time", "s", "CPU time outside RVEs: finite elements, output, waiting threads."},
      {"rve_share_of_cpu_time", "1", "CPU time inside RVEs over that of the whole run."}};
}

std::vector<OutputDefinition> skipping_results() {
  return {
      {"rve_asks", "",
       "Number of stresses that steps have asked for, of all quadrature points; those asked again of a "
       "committed time do not count.",
       skipped},
      {"rve_asks_per_call", "1",
       "These asks over the number of evaluations of an RVE, all of those included.", skipped},
      {"skipped_share", "1", "Share of the asks that were answered from the table of earlier answers.",
       skipped},
      {"history_share_of_asks", "1",
       "Share of the asks from points whose walls had yielded or broken: called in full.", skipped},
      {"skipping_records", "", "Number of answers in the table.", skipped},
      {"skipping_tolerance", "Pa", "Error of a stress (norm of P) that the table aims at.", skipped},
      {"skipping_audits", "", "Number of answers from the table that were drawn and computed after all.",
       skipped},
      {"skipping_audits_refuted", "", "Number of these that were off by more than the tolerance.", skipped},
      {"look_up_time_per_ask", "s",
       "Wall time of looking up, answering from and keeping the table, over the number of asks.", skipped},
      {"skipping_error_rms", "Pa",
       "Root mean square of the stress error (norm of P) of the answers from the table, by the audits.",
       audited},
      {"skipping_error_p99", "Pa", "99th percentile of that error, by the audits.", audited},
      {"skipping_error_worst", "Pa", "Largest error that an audit found.", audited},
      {"skipping_largest_stress", "Pa",
       "Largest stress (norm of P) of any point after any step: what these errors are to be seen beside.",
       audited},
      {"skipping_error_rms_bound", "Pa",
       "Upper bound of the root mean square over all answers from the table, which holds with 95 % if errors "
       "have no heavier tail than the sample: none where an audit was above the tolerance.",
       bounded},
      {"skipping_error_p99_bound", "Pa",
       "Upper bound of the 99th percentile over all answers from the table, which holds with 95 %.",
       bounded}};
}

Outputs cost_outputs() {
  Outputs all;
  all.results(call_results())
      .results(skipping_results())
      .results({{"rank_imbalance", "1",
                 "Cost of the RVEs of the busiest rank over the mean of the ranks, smoothed.", ranks},
                {"rank_rebalances", "", "How often RVEs were shared anew among the ranks.", ranks}})
      .table("cost", "One row for each step of the tissue.",
             {{"time", "s", "Time since the start of the run, at the end of the step."},
              {"time_step", "s", "Length of the last step of the tissue."},
              {"rve_calls", "", "Number of evaluations of an RVE since the row before."},
              {"rve_iterations_mean", "1", "Mean number of iterations of these evaluations."},
              {"rve_iterations_max", "",
               "Largest number of iterations of an evaluation since the start of the run."},
              {"rve_calls_failed", "", "Number of these evaluations that gave no stress."},
              {"rve_cpu_time", "s",
               "CPU time inside RVEs since the row before, all threads and ranks together."},
              {"rank_imbalance", "1",
               "Cost of the RVEs of the busiest rank over the mean of the ranks, smoothed; 1 on one rank."}});
  return all;
}
}  // namespace

Outputs outlines_outputs() {
  Outputs all;
  all.table("rve_outlines", "The corners of the cells' walls in some RVEs, for pictures.",
            {{"time", "s", "Time since the start of the run."},
             {"rve", "", "Number of the quadrature point that the RVE belongs to."},
             {"ring", "", "Number of the cell in the RVE."},
             {"point_x", "m", "Present place of the quadrature point along x."},
             {"point_y", "m", "Present place of the quadrature point along y."},
             {"F_*", "1", "That component (row, column) of the deformation gradient at the point."},
             {"period_*", "m",
              "Period of the undeformed RVE: of the first along x, of the second along y, and where they are "
              "oblique the other components (component, period)."},
             {"pressure", "Pa", "Mean pressure of the fluid in the RVE."},
             {"stress_xy", "Pa", "Shear component of the Cauchy stress of the RVE."},
             {"x", "m", "Place of the wall's corner inside the RVE along x."},
             {"y", "m", "Place of the wall's corner inside the RVE along y."}});
  return all;
}

Outputs tissue_run_outputs() {
  Outputs all;
  all.results(energy_results());
  return all.join(energy_table())
      .join(cost_outputs())
      .join(outlines_outputs(), "with Outlined RVEs > 0")
      .join(tissue_field_outputs());
}

Outputs tip_swing_outputs() {
  Outputs all = tip_outputs(true);
  const char *most = "where the tip turned", *back = "where the tip came back";
  all.results(
      {{"tip_largest_deflection", "m",
        "Largest deflection of the tip along the load, by a parabola through the rows around it."},
       {"time_of_largest_deflection", "s", "Time of that largest deflection, by the same parabola.", most},
       {"period_from_maximum", "s", "Period of the swing as twice the time of the largest deflection.", most},
       {"period_from_return", "s",
        "Period of the swing as the time at which the tip is back at its least deflection.", back},
       {"tip_deflection_at_return", "m", "Deflection of the tip along the load at that return.", back}});
  return all.join(cell_displacement_outputs());
}

Outputs tissue_field_outputs() {
  Outputs all;
  all.fields("tissue", "The mesh of the tissue as it is deformed.",
             {{"displacement", "m", "Displacement of the node since the undeformed state."},
              {"velocity", "m/s", "Velocity of the node of the mesh."},
              {"stress", "Pa",
               "Cauchy stress of the element, mean over its quadrature points, positive in tension."},
              {"pressure", "Pa", "Minus half the trace of that Cauchy stress, in the plane."},
              {"fluid pressure", "Pa", "Pressure of the cells' fluid, mean over the element's RVEs."},
              {"failed", "1", "Share of the cells that have failed, mean over the element's RVEs.", torn},
              {"permanent stretch", "1",
               "Permanent stretch of the walls by yielding, mean over the element's RVEs.", torn}});
  return all;
}

Outputs TissueGravity::outputs() const {
  Outputs all = block_outputs();
  return all.join(tip_swing_outputs()).join(tissue_run_outputs());
}

Outputs TissueBruise::outputs() const {
  Outputs all;
  all.results(
      {{"density", "kg/m^3", "Mass of wall and fluid over the volume of a cell, in the unloaded state."},
       {"tool_radius", "m", "Radius of the cylinder that hits the block.", "with Impact/Tool = cylinder"}});
  return all.join(bruise_outputs()).join(tissue_run_outputs());
}

Outputs TissueStatics::outputs() const {
  Outputs single;
  single.results(
      {{"tip_over_width", "1", "Deflection of the middle of the free side along the load, over the width."},
       {"pressure_min", "Pa", "Lowest mean fluid pressure of an RVE under the load."},
       {"pressure_max", "Pa", "Highest mean fluid pressure of an RVE under the load."},
       {"newton_iterations", "", "Number of Newton iterations of the tissue, rejected increments included."},
       {"load_increments", "", "Number of increments in which the load was put on."},
       {"residual", "1", "Norm of the nodal forces left unbalanced at the end, over that of the load."},
       {"residual_of_round_off", "1",
        "Norm of the unbalanced nodal forces that rounding alone leaves, over that of the load."},
       {"rve_points", "", "Number of quadrature points, each with an RVE of its own."},
       {"rve_calls", "", "Number of evaluations of an RVE."},
       {"rve_cpu_time", "s", "CPU time inside RVEs, all threads and ranks together."},
       {"solve_time", "s", "Wall time of the whole run, setting up included."}});
  Outputs all = tip_outputs(false);
  return all.join(block_outputs())
      .join(single.join(cell_displacement_outputs()), "with Loads/Way = at_once")
      .join(static_run_outputs(), "with Loads/Way = steps")
      .join(arc_run_outputs(), "with Loads/Way = arc_length")
      .join(tissue_field_outputs());
}
}  // namespace turgor
