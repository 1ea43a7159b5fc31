#include "micro/scenes/matrix/rod_migration.h"

namespace turgor {
Outputs RodMigration::outputs() const {
  const char *drawn = "with Frames above 0";
  Outputs all;
  all.results(
         {{"cells", "", "Number of cells that were followed."},
          {"displacement", "m",
           "Distance of a cell's middle at the end from where it began, mean of all cells."},
          {"displacement_error", "m", "Standard error of that mean; 0 of a single cell."},
          {"right_share", "1", "Share of the cells whose middle ends at x > 0, on the stiff side."},
          {"right_share_low", "1", "Lower end of the 95 % interval of that share (Wilson)."},
          {"right_share_high", "1", "Upper end of the 95 % interval of that share (Wilson)."},
          {"right_shift", "m", "x of a cell's middle at the end, mean of all cells."},
          {"right_shift_error", "m", "Standard error of that mean; 0 of a single cell."},
          {"path", "m", "Length of a cell's path from row to row of paths.csv, mean of all cells."},
          {"speed", "m/s", "Length of the path over the time, mean of all cells."},
          {"rod_length", "m", "Length L of the rod, mean of all rows and cells."},
          {"protrusions", "", "Number of protrusions that hold, mean of all rows and cells."},
          {"rounded_up", "", "How often a cell that was stuck rounded up, mean of all cells."},
          {"at_border", "",
           "Number of cells whose way ended because they came near the border of the network."},
          {"energy_lost", "1",
           "Largest share, of all cells, of energy that is neither stored nor became heat, over all that "
           "protrusions and degradation put in and took out."},
          {"steps", "", "Number of steps that were taken."},
          {"rejected_steps", "",
           "Number of steps that were tried and repeated with half their length or less."}})
      .table("cells", "One row for each cell.",
             {{"seed", "", "Seed of the network and of all that is random of the cell."},
              {"time", "s", "Time for which it was followed."},
              {"displacement", "m", "Distance of its middle at the end from where it began."},
              {"x", "m", "Of its middle at the end, from where it began."},
              {"y", "m", "Of its middle at the end, from where it began."},
              {"path", "m", "Length of its path from row to row of paths.csv."},
              {"rod_length", "m", "Length L of the rod, mean of its rows."},
              {"protrusions", "", "Number of protrusions that hold, mean of its rows."},
              {"attached", "", "How often a protrusion took hold."},
              {"rounded_up", "", "How often it was stuck and rounded up."},
              {"at_border", "", "1: its way ended near the border of the network, 0: it did not."},
              {"energy_lost", "1", "Share of work that is neither stored nor became heat."}})
      .table("paths", "Rows of all cells, one after the other, spread evenly over time.",
             {{"seed", "", "Seed of the cell, as in cells.csv."},
              {"time", "s", "Time since the cell itself was started."},
              {"x", "m", "Of the cell's middle, from where it began."},
              {"y", "m", "Of the cell's middle, from where it began."},
              {"rod_length", "m", "Length L of the rod."},
              {"protrusions", "", "Number of protrusions that hold."},
              {"pull", "N", "Magnitude of the sum of their forces on the cell."},
              {"polarity", "rad", "Angle of the polarity with the x axis, 0 of a round cell."}})
      .fields("cell", "The rod, the fibres and the protrusions of the first cell as lines.",
              {{"radius", "m", "Radius of the rod, 0 of other lines.", drawn},
               {"tension", "N", "Tension of fibres and protrusions, 0 of the rod.", drawn},
               {"kind", "", "0: fibre, 1: protrusion, 2: rod.", drawn}});
  return all;
}
}  // namespace turgor
