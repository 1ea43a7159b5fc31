#include "coupling/tissue_outputs.h"
#include "micro/scenes/blow_table.h"

namespace turgor {
namespace {
std::vector<OutputDefinition> bruise_results() {
  const char *failed = "where a cell failed";
  return {
      {"bruised_share", "1",
       "Share of the block's area whose cells have failed at the end; a point counts with its share of "
       "failed cells."},
      {"bruised_area", "m^2", "Bruised share times the undeformed area of the block."},
      {"bruise_depth", "m",
       "Distance in the undeformed block from the side that is hit to the deepest quadrature point with a "
       "failed cell; 0: none."},
      {"bruise_at_support", "",
       "Whether a cell has failed in the elements at the support, so that the block's size decides: 1 yes, 0 "
       "no."},
      {"tool_penetration_max", "m",
       "Largest depth of a point of the surface, at a node or between two, inside the tool."},
      {"support_penetration_max", "m",
       "Largest depth of a point of the surface, at a node or between two, inside the support's plate."},
      {"penetration_share_max", "1",
       "The larger of the two over the smaller of an element's thickness and the tool's radius."},
      {"peak_force", "N/m", "Largest force of the tissue on the tool, per metre of depth."},
      {"time_of_peak_force", "s", "Time since the start of the run of that largest force."},
      {"peak_transmitted_force", "N/m", "Largest force on the support, per metre of depth."},
      {"impulse", "N s/m", "Integral of the force on the tool over the run, per metre of depth."},
      {"time_of_first_failure", "s", "Time at which the first cell failed.", failed},
      {"strain_at_first_failure", "1",
       "Way of the tool until the first cell failed, over the width of the block.", failed},
      {"largest_permanent_stretch", "1",
       "Largest mean permanent stretch by yielding of the walls of an RVE, in any step."},
      {"mean_permanent_stretch", "1",
       "Permanent stretch by yielding of the walls at the end, mean over the block's area."},
      {"final_mean_F_xx", "1", "Stretch of the block along the blow at the end: F_xx, mean over its area."},
      {"final_mean_F_yy", "1", "Stretch of the block across the blow at the end: F_yy, mean over its area."},
      {"final_plates_stress_xx", "Pa",
       "Mean Cauchy stress between tool and support at the end as in an even block, P_xx/F_yy, negative in "
       "compression."},
      {"tool_work", "J/m", "Work of the tool on the tissue, per metre of depth."},
      {"dissipated_by_flow", "J/m", "Energy that yielding walls have dissipated, per metre of depth."},
      {"dissipated_by_failure", "J/m", "Energy that breaking walls have set free, per metre of depth."}};
}
}  // namespace

Outputs bruise_outputs() {
  Outputs all;
  all.results(bruise_results())
      .table(
          "impact", "One row for each step of the tissue, forces and energies per metre of depth.",
          {{"time", "s", "Time since the start of the run."},
           {"travel", "m", "Way that the tool has gone since the start."},
           {"force", "N/m", "Force of the tissue on the tool, positive against its motion."},
           {"transmitted_force", "N/m", "Force of the tissue on the support, positive away from the tool."},
           {"tool_work", "J/m", "Work of the tool on the tissue since the start."},
           {"bruised_share", "1", "Share of the block's area whose cells have failed."},
           {"mean_permanent_stretch", "1",
            "Permanent stretch by yielding of the walls, mean over the block's area."},
           {"dissipated_by_flow", "J/m", "Energy that yielding walls have dissipated since the start."},
           {"dissipated_by_failure", "J/m", "Energy that breaking walls have set free since the start."}})
      .table("rve_points", "One row for each quadrature point and frame.",
             {{"time", "s", "Time of the frame since the start of the run."},
              {"x", "m", "Present place of the quadrature point along x."},
              {"y", "m", "Present place of the quadrature point along y."},
              {"failed", "1", "Share of the cells of the point's RVE that have failed."},
              {"permanent_stretch", "1",
               "Mean permanent stretch of the walls of the point's RVE by yielding, over that of the "
               "undeformed state, minus one."},
              {"pressure", "Pa", "Mean pressure of the fluid in the point's RVE."},
              {"F_xx", "1", "Stretch component F_xx of the deformation gradient at the point."},
              {"F_yy", "1", "Stretch component F_yy of the deformation gradient at the point."}});
  return all.join(blow_outputs());
}
}  // namespace turgor
