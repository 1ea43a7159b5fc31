#include "micro/scenes/blow_table.h"
#include "micro/scenes/shared_outputs.h"
#include "micro/scenes/tissue/tissue_loading.h"

namespace turgor {
namespace {
const char *const breaks = "with a Critical stretch", *const ties = "with a Lamella strength",
                  *const reached = "as far as the run got";

OutputDefinition at_strains(const std::string &name, const std::string &unit, const std::string &text) {
  return {name + "_at_*_percent", unit, text + " at the strain that the name says.", reached};
}

Outputs tables() {
  Outputs all;
  all.table("loading", "One row for each of Samples equal parts of the plate's way.",
            {{"time", "s", "Time since the upper plate began to move."},
             {"strain", "1", "Way of the upper plate over the height of the inflated tissue."},
             {"force_upper", "N", "Force of the tissue on the upper plate, which moves, positive upwards."},
             {"force_lower", "N", "Force of the tissue on the lower plate, which stays, positive downwards."},
             {"stress_upper", "Pa",
              "Nominal stress: force on the upper plate over (width of the inflated tissue times depth)."},
             {"stress_lower", "Pa",
              "Nominal stress: force on the lower plate over (width of the inflated tissue times depth)."},
             {"plate_upper", "m", "Place of the upper plate along y."},
             {"mean_pressure", "Pa",
              "Pressure of the fluid by its equation of state, mean over each cell and over the cells."}})
      .table("loading", "", energy_columns())
      .table(
          "loading", "",
          {{"work", "J", "Work of the upper plate since it began to move."},
           {"centre_of_flattening", "1",
            "Mean depth of the cells' flattening: 0 all at the moving plate, 1 all at the other, 0.5 even."},
           {"flattest_cell", "1",
            "Largest flattening of a cell: 1 - its height over its height at the start."},
           {"stretch_near_plate", "1",
            "Mean stretch of the unbroken walls of the cells in the first fifth below the upper plate."},
           {"mean_stretch", "1", "Mean stretch of all unbroken bonds of walls, length over length at rest."},
           {"largest_stretch", "1", "Largest stretch of an unbroken bond of a wall."},
           {"failed_cells", "", "Number of cells with at least one broken bond."},
           {"broken_bonds", "", "Number of bonds of walls that have broken."},
           {"broken_ties", "", "Number of ties of the middle lamella between cells that have broken."},
           {"failed_depth", "1",
            "Mean depth at the start of the failed cells below the upper plate, over the height of the "
            "tissue; 0: none."},
           {"crossed", "", "Number of fluid particles that are outside a wall that is whole."},
           {"given_off", "J",
            "Energy that broken bonds and ties have taken along and walls that yielded have taken."},
           {"heat", "J",
            "Energy that viscosity and Damping have turned to heat; of turgor's energy too, where walls "
            "yielded or broke, so that it can be above the work."},
           {"overlap", "m",
            "How much closer two walls of different cells are than the range of their contact, at most."},
           {"crossed_bonds", "", "Number of bonds of walls that have passed through another cell's wall."},
           {"behind_plate", "m", "How far the particle that is farthest behind a plate stands behind it."}})
      .table("rows", "Flattening of each row of cells, at the times of loading.csv.",
             {{"time", "s", "Time since the upper plate began to move."},
              {"strain", "1", "Way of the upper plate over the height of the inflated tissue."},
              {"row_*", "1",
               "Mean of 1 - height over height at the start of the cells of that row, the lowest being 0."}})
      .join(
          Outputs().fields(
              "cells", "All particles of walls and fluid.",
              {{"velocity", "m/s", "Velocity of the particle of wall or fluid."},
               {"pressure", "Pa", "Pressure of a particle of fluid by the equation of state; 0 in the wall."},
               {"wall", "", "What the particle is: 1 wall, 0 fluid."},
               {"cell", "", "Number of the particle's cell, from 0, row by row from the lowest."},
               {"failed", "", "Whether the particle's cell has failed: 1 a bond of it is broken, else 0."}}),
          "with Frames > 0");
  return all;
}

std::vector<OutputDefinition> of_failure() {
  return {
      {"failed_cells", "", "Number of cells with at least one broken bond at the end.", breaks},
      {"failed_share", "1", "Share of all cells that have failed by the end.", breaks},
      {"strain_at_first_failure", "1", "Strain at which the first cell failed; -1: none did.", breaks},
      {"strain_at_*_percent_of_failures", "1",
       "Strain at which that share of the cells that fail in this run had failed; -1: none did.", breaks},
      {"failure_sigmoid_centre", "1",
       "Strain at the middle of the logistic curve fitted to the number of failed cells.", breaks},
      {"failure_sigmoid_width", "1", "Width of that curve: strain in the exponent's denominator.", breaks},
      {"failure_sigmoid_explains", "1",
       "Share of the variance of the number of failed cells that the curve explains.", breaks},
      {"failed_depth_first", "1",
       "Mean depth of the failed cells when a quarter of those that fail had failed, over the tissue's "
       "height.",
       breaks},
      {"failed_depth", "1",
       "Mean depth of the failed cells below the upper plate at the end, over the tissue's height.", breaks},
      {"broken_bonds", "", "Number of bonds of walls that broke.", breaks},
      {"broken_bonds_at_junctions", "1",
       "Share of the broken bonds within an eighth of a cell side of where three cells meet.", breaks},
      {"largest_tie_stress_inflated", "Pa",
       "Largest stress of a tie of the middle lamella in the inflated tissue: force over bond length times "
       "depth.",
       "of tissues with a lamella"},
      {"broken_ties", "", "Number of ties of the middle lamella that broke.", ties},
      {"broken_tie_share", "1", "Share of all ties of the middle lamella that broke.", ties},
      {"strain_at_first_tie", "1", "Strain at which the first tie broke; -1: none did.", ties},
      {"first_ties_from_wall_end", "m",
       "Mean distance of the first fifth of the broken ties from the end of their shared wall.", ties},
      {"last_ties_from_wall_end", "m",
       "Mean distance of the last fifth of the broken ties from the end of their shared wall.", ties}};
}

std::vector<OutputDefinition> of_widening_strips() {
  const char *const widening = "with Sides = widening";
  return {{"width_at_end", "m", "Period of the strip along x at the end.", widening},
          {"largest_lateral_stress", "Pa",
           "Largest mean stress along x while the plate moved, which should be zero.", widening},
          {"work_of_sides", "J",
           "Work of the sides on the tissue while the plate moved, which should be zero as no stress is "
           "left along x.",
           widening}};
}
}  // namespace

Outputs TissueLoading::outputs() const {
  Outputs all;
  all.results(
         {{"particles", "", "Number of particles of walls and fluid together."},
          {"steps", "", "Number of time steps of inflation and squeezing together."},
          {"time_step", "s",
           "Longest time step while the plate moves; where the tissue demands shorter ones, steps are taken "
           "in parts."},
          {"inflated_height", "m",
           "Height of the inflated tissue when the plates touch it, from the lowest to the highest wall "
           "node."},
          {"inflated_width", "m",
           "Largest extent of the inflated tissue along x; of a strip its period along x."},
          {"void_fraction", "1",
           "Share of the area covered by no cell, in the box of the centres of the outermost cells of the "
           "inflated tissue."},
          {"pressure_inflated", "Pa", "Mean pressure of the cells when the tissue is inflated and at rest."},
          {"rest_residual", "1",
           "Largest force left unbalanced on a node of a wall of the inflated tissue, over turgor times the "
           "wall of a node."},
          {"mean_stretch_inflated", "1", "Mean stretch of all bonds of walls in the inflated tissue."},
          {"junction_angle_deviation_inflated", "degrees",
           "Root mean square of the angles of cells where three meet minus 120 degrees, in the inflated "
           "tissue."},
          {"junction_angle_deviation_laid", "degrees",
           "The same deviation of the angles from 120 degrees before the inflation."},
          {"junction_angle_deviation_end", "degrees",
           "The same deviation of the angles from 120 degrees at the end of the run."},
          {"stress_lower_at_end", "Pa", "Nominal stress on the lower plate at the end of the run."},
          {"modulus_start", "Pa",
           "Slope of the mean stress on both plates against strain from 2 to 10 %, least squares; 0: not "
           "that far."},
          {"modulus_later", "Pa",
           "Slope of the mean stress on both plates against strain from 20 to 30 %, least squares; 0: not "
           "that far."},
          at_strains("stress_lower", "Pa",
                     "Nominal stress that reaches the lower plate, mean over half a per cent of strain to "
                     "each side,"),
          at_strains("stress_upper", "Pa",
                     "Nominal stress on the upper plate, mean over half a per cent of strain to each side,"),
          at_strains("centre_of_flattening", "1",
                     "Mean depth of the cells' flattening (0 at the moving plate, 1 at the other, 0.5 even)"),
          at_strains("flattest_cell", "1", "Largest flattening of a cell"),
          at_strains("stretch_near_plate", "1",
                     "Mean stretch of the walls of the cells in the first fifth below the upper plate"),
          at_strains("largest_stretch", "1", "Largest stretch of an unbroken bond of a wall"),
          at_strains("mean_stretch", "1", "Mean stretch of all unbroken bonds of walls"),
          {"largest_stress_lower", "Pa", "Largest nominal stress on the lower plate in any row."},
          {"flattest_cell_ever", "1", "Largest flattening of a cell in any row."},
          {"stress_lower_oscillation", "1",
           "Sum of all falls of the stress on the lower plate (mean over 1/80 of the run) over its range."},
          {"work", "J", "Work of the upper plate over the whole way."},
          {"energy_unaccounted", "J",
           "Start energy and work less the tissue's energy, what breaking gave off and flow took: what heat "
           "should be."},
          {"energy_given_off_by_breaking", "J",
           "Energy that broken bonds and ties have taken along; what created it is taken off."},
          {"energy_created_by_breaking", "J",
           "Energy that breaking has added to the tissue, which is no physics and should be small."},
          {"heat", "J",
           "Energy that viscosity and Damping have turned to heat; of turgor's energy too, where walls "
           "yielded or broke, so that it can be above the work."},
          {"energy_taken_by_flow", "J", "Energy that walls took up by yielding.",
           "with walls that yield plastically"},
          {"largest_permanent_stretch", "1", "Largest permanent stretch of a bond by yielding.",
           "with walls that yield plastically"}})
      .results(of_widening_strips())
      .results(of_failure())
      .results(
          {{"deepest_overlap", "m",
            "Largest overlap of two walls of different cells with the range of their contact in any row."},
           {"deepest_behind_plate", "m", "Largest distance of a particle behind a plate in any row."},
           {"most_crossed_bonds", "",
            "Largest number of bonds that have passed through another cell's wall in any row."},
           {"most_crossed", "", "Largest number of fluid particles outside a whole wall in any row."},
           {"energy_balance_error", "1",
            "Energy that is missing at the end over the plate's work; negative: it came from nothing."}});
  return all.join(tables()).join(blow_outputs());
}
}  // namespace turgor
