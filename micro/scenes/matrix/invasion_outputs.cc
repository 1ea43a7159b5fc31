#include "micro/scenes/matrix/invasion.h"

namespace turgor {
Outputs Invasion::outputs() const {
  const char *drawn = "with Frames above 0";
  Outputs all;
  all.results(
         {{"cells", "", "Number of cells of the colony."},
          {"colony_radius", "m", "From the middle of the colony to its farthest side, at the start."},
          {"time", "s", "Time for which the colony was followed."},
          {"front_advance", "m",
           "How much farther from the middle than at the start the distance is that 95 % of the cells do not "
           "exceed."},
          {"invaded_share", "1",
           "Share of the cells whose middle is beyond the radius of the colony at the start."},
          {"radius_of_gyration_growth", "1", "Radius of gyration at the end over that at the start, less 1."},
          {"displacement", "m", "Distance of a cell's middle from where it began, mean of all cells."},
          {"displacement_rim", "m",
           "The same, mean of the cells that lay within two of their diameters of the rim."},
          {"rod_length", "m", "Length L of the rods at the end, mean of all cells."},
          {"longest_rod", "m", "Length L of the longest rod at the end."},
          {"protrusions", "", "Number of protrusions of a cell that hold, mean of all rows and cells."},
          {"rounded_up", "", "How often a cell that was stuck rounded up, mean of all cells."},
          {"energy_lost", "1",
           "Share of energy that is neither stored nor became heat, over all that protrusions and "
           "degradation "
           "put in and took out."},
          {"steps", "", "Number of steps that were taken."},
          {"rejected_steps", "",
           "Number of steps that were tried and repeated with half their length or less."}})
      .table(
          "history", "The colony over time.",
          {{"time", "s", "Time since the start of the run."},
           {"front", "m", "Distance from the middle that 95 % of the cells do not exceed."},
           {"radius_of_gyration", "m", "Root of the mean square of the distance from the cells' mean place."},
           {"invaded_share", "1", "Share of the cells beyond the radius of the colony at the start."},
           {"displacement", "m", "Distance of a cell's middle from where it began, mean of all cells."},
           {"rod_length", "m", "Length L of the rods, mean of all cells."},
           {"protrusions", "", "Number of protrusions of a cell that hold, mean of all cells."}})
      .table("cells", "One row for each cell, at the end.",
             {{"cell", "", "Its number, from the middle of the colony outwards."},
              {"x_start", "m", "Of its middle at the start."},
              {"y_start", "m", "Of its middle at the start."},
              {"x", "m", "Of its middle at the end."},
              {"y", "m", "Of its middle at the end."},
              {"rod_length", "m", "Length L of the rod."},
              {"protrusions", "", "Number of protrusions that hold."}})
      .fields("colony", "Rods, fibres and protrusions as lines; the rods come first.",
              {{"radius", "m", "Radius of the rods, 0 of other lines.", drawn},
               {"tension", "N", "Tension of fibres and protrusions, 0 of rods.", drawn},
               {"kind", "", "0: fibre, 1: protrusion, 2: rod.", drawn}});
  return all;
}
}  // namespace turgor
