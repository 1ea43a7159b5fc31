#include "micro/scenes/spheroid/monolayer.h"
#include "micro/scenes/spheroid/spheroid_capsule.h"
#include "micro/scenes/spheroid/spheroid_dextran.h"
#include "micro/scenes/spheroid/spheroid_free.h"
#include "micro/scenes/spheroid/spheroid_relaxation.h"

namespace turgor {
namespace {
/// What is both a column of growth.csv and, of its last row, a result.
const std::vector<OutputDefinition> state_of_the_population = {
    {"cells", "", "Number of all cells, living and dead, that are still there."},
    {"proliferating", "", "Number of living cells that go through the cycle."},
    {"quiescent", "",
     "Number of living cells that rest, because of contact inhibition, of their depth or by the scene."},
    {"necrotic", "", "Number of dead cells whose volume is on its way to the solid part."},
    {"lysed", "", "Number of dead cells of which only the solid part is left."},
    {"radius", "m",
     "Mean distance from the centroid of the cells that are at least half exposed to the outside, plus one "
     "mean cell radius."},
    {"gyration_radius", "m",
     "Square root of 5/3 (a monolayer: 2) times the mean squared distance of cell centres from their "
     "centroid, which is the radius of a full sphere (disc) of centres."},
    {"volume", "m^3", "Sum of the present volumes of all cells, without the gaps between them."},
    {"pressure", "Pa",
     "Mean over the living cells, weighted with their volumes, of the pressure that contacts and "
     "surroundings put on each, positive in compression."},
    {"strain", "1",
     "Mean over the living cells, weighted with their volumes, of the volumetric strain -log(V/V_ref) "
     "against the volume without pressure, positive when compressed."},
    {"density", "1/(100 um^2)",
     "Cells with centres within 5 um of the plane through the centroid (a monolayer: all), per 100 um^2 of "
     "the circle of that radius."}};

Outputs of_growth() {
  Outputs all;
  all.results({{"time", "s", "Simulated time at the end of the run."}})
      .results(state_of_the_population)
      .results(
          {{"divisions", "", "Number of divisions since the start of the run."},
           {"deaths", "", "Number of cells that have become necrotic since the start."},
           {"interval", "s",
            "Length of an interval between two looks at the cells' life: volumes, divisions, deaths."},
           {"steps", "", "Number of accepted steps of the cells' motion."},
           {"rejected_steps", "",
            "Number of steps that were repeated with a shorter length because their error was too large."}})
      .table("growth", "One row for each of Samples equal parts of End time and one at the end.",
             {{"time", "s", "Simulated time since the start of the run."}})
      .table("growth", "", state_of_the_population)
      .table(
          "growth", "",
          {{"grown_volume", "m^3", "Volume that all cells together have gained by growth since the start."},
           {"drained_volume", "m^3",
            "Volume that dead cells have lost on the way to their solid part since the start."},
           {"proliferating_volume", "m^3", "Sum of the present volumes of the proliferating cells."}})
      .fields(
          "cells", "Each point is the centre of a cell, in the order of birth.",
          {{"radius", "m", "Radius of the cell as a sphere.", "with Frames > 0"},
           {"volume", "m^3", "Present volume of the cell, compressed as it is.", "with Frames > 0"},
           {"pressure", "Pa", "Pressure on the cell, positive in compression.", "with Frames > 0"},
           {"strain", "1",
            "Volumetric strain -log(V/V_ref) of the cell against its volume without pressure, positive when "
            "compressed.",
            "with Frames > 0"},
           {"phase", "1", "How far the cell is in its cycle: 0 newborn, 1 about to divide.",
            "with Frames > 0"},
           {"state", "", "The cell's state as a number: 0 proliferating, 1 quiescent, 2 necrotic, 3 lysed.",
            "with Frames > 0"}});
  return all;
}

Outputs of_free_growth() {
  Outputs all;
  const char *rim = "with a Rim and a run longer than a cycle";
  all.results(
      {{"doubling_time_closed_form", "s",
        "Time in which exponential growth doubles the number of cells, from the mean and the spread of the "
        "cycle time."},
       {"doubling_time", "s",
        "ln 2 over the slope of ln(cells) by least squares over the last whole number of cycles.",
        "where the cells double within the times of the fit"},
       {"doubling_time_error", "1", "Doubling time over its closed form, minus one.",
        "where the cells double within the times of the fit"},
       {"deviation_from_exponential", "1",
        "Largest relative distance of the number of cells from the fitted exponential within the times of "
        "the fit.",
        "of runs longer than a cycle"},
       {"radial_speed", "um/d", "Slope of the radius over the second half of the run by least squares.", rim},
       {"radial_speed_closed_form", "um/d",
        "Speed with which the growth of a rim of this thickness moves the edge outwards at the mean radius "
        "of the second half.",
        rim},
       {"radial_speed_closed_form_mean", "um/d",
        "Mean of that closed form over the second half of the run, at the radius of each row.", rim},
       {"rim_production_error", "1",
        "Volume gained over the second half against growth rate times the proliferating volume, minus one.",
        "with a quiescent rim"}});
  return all;
}
}  // namespace

Outputs SpheroidScene::outputs() const {
  Outputs all = of_growth();
  return all.join(more_outputs());
}

Outputs SpheroidFree::more_outputs() const { return of_free_growth().join(BodyEntries::outputs()); }

Outputs SpheroidRelaxation::more_outputs() const {
  Outputs all;
  const char *reached = "where the size came back within the run";
  all.results(
      {{"gyration_radius_compressed", "m", "Gyration radius of the compressed spheroid when it is let go."},
       {"gyration_radius_at_rest", "m", "Gyration radius of the spheroid at the end of the run."},
       {"relaxation_time", "s",
        "Time after which 1 - 1/e of the way from the compressed gyration radius to that at the end is made.",
        reached},
       {"relaxation_time_over_that_of_a_cell", "1",
        "Relaxation time of the spheroid over that of a single cell's volume (at least 1 s).", reached}});
  return all;
}

Outputs SpheroidCapsule::more_outputs() const {
  Outputs all;
  const char *after[] = {"of runs that reach the wall", "of runs that go on for a day after confluence",
                         "of runs that go on for two days after confluence"};
  all.results(
         {{"capsule_radius", "m", "Inner radius of the capsule at the end of the run."},
          {"capsule_pressure", "Pa",
           "Pressure of the cells on the capsule's wall at the end: sum of their normal forces over the "
           "inner surface."},
          {"largest_capsule_pressure", "Pa",
           "Largest pressure of the cells on the capsule's wall in any row of growth.csv."},
          {"confluence_time", "s",
           "First time at which the spheroid's radius is 99 % of the capsule's radius at rest.", after[0]},
          {"confluence_density", "1/(100 um^2)", "Density of cells in the section at confluence.", after[0]},
          {"capsule_pressure_24h", "Pa", "Pressure on the wall 24 h after confluence.", after[1]},
          {"density_48h", "1/(100 um^2)", "Density of cells in the section 48 h after confluence.", after[2]},
          {"density_ratio_48h", "1", "Density 48 h after confluence over that at confluence.", after[2]},
          {"capsule_pressure_48h", "Pa", "Pressure on the wall 48 h after confluence.", after[2]},
          {"dilatation_48h", "m", "Inner radius of the capsule 48 h after confluence minus that at rest.",
           after[2]},
          {"residual_growth", "um/d",
           "Slope of the capsule's inner radius by least squares, from 48 h after confluence on (shorter "
           "runs: over the last third).",
           after[1]},
          {"fastest_growth", "um/d",
           "Largest slope of the capsule's inner radius over 12 h after confluence.", after[1]},
          {"transition_time", "s",
           "Time since confluence at which the lines of fastest and residual growth cross.",
           "where growth slows down by a sixth at least"},
          {"transition_pressure", "Pa", "Pressure on the wall at the transition time.",
           "where growth slows down by a sixth at least"}})
      .table("growth", "",
             {{"capsule_radius", "m", "Present inner radius of the capsule."},
              {"capsule_pressure", "Pa",
               "Sum of the cells' normal forces on the capsule over its inner surface."},
              {"cells_on_capsule", "", "Number of cells that touch the capsule."}});
  return all;
}

Outputs SpheroidDextran::more_outputs() const {
  Outputs all;
  const char *changes = "of cell lines whose rim changes, from a day after the change on";
  all.results(
         {{"radial_speed", "um/d", "Slope of the radius by least squares from the first day to the end.",
           "of runs longer than two days"},
          {"mean_pressure", "Pa", "Mean of the pressure in the rows of growth.csv from the first day on.",
           "of runs longer than two days"},
          {"radial_speed_first", "um/d",
           "Slope of the radius by least squares before the rim changes, from the first day on.", changes},
          {"radial_speed_second", "um/d",
           "Slope of the radius by least squares from half a day after the rim changed to the end.", changes},
          {"pressure_rim", "Pa",
           "Pressure at the end in the outermost shell of profile.csv, mean over its cells' volumes."},
          {"pressure_core", "Pa",
           "Pressure at the end within half the radius, mean over the cells of those shells.",
           "where a shell lies so deep"}})
      .table("profile", "One row for each shell of a mean cell diameter at the end, from the edge inwards.",
             {{"depth", "m", "Distance of the middle of the shell below the edge of the spheroid."},
              {"pressure", "Pa", "Pressure of the cells with centres in the shell, mean over their volumes."},
              {"pressure_scatter", "Pa",
               "Standard deviation of the pressures of these cells, by their volumes."},
              {"cells", "", "Number of cells with centres in the shell."}})
      .table(
          "growth", "",
          {{"unit_force", "N",
            "F_0, the force on an outer cell that is wholly exposed and has its reference volume.",
            "with Dextran/Pressure > 0"},
           {"outer_cells", "1", "Sum of the exposures of all cells: how many wholly exposed ones they make.",
            "with Dextran/Pressure > 0"}});
  return all;
}
}  // namespace turgor
