#include "micro/scenes/shared_outputs.h"

namespace turgor {
Outputs round_cell_field_outputs() {
  Outputs all;
  all.fields("wall", "The cell's wall: nodes with the bonds (2D) or faces (3D) that hold.",
             {{"stretch", "1", "Largest stretch of the unbroken bonds that end at the node."},
              {"broken", "", "Number of broken bonds that ended at the node."}})
      .join(
          Outputs().fields("fluid", "The particles of the cell's fluid.",
                           {{"pressure", "Pa", "Pressure of the particle by the fluid's equation of state."},
                            {"velocity", "m/s", "Velocity of the particle of fluid."}}),
          "with fluid particles");
  return all;
}

Outputs cell_displacement_outputs() {
  Outputs all;
  all.table(
      "cell_displacement", "One row for each cell of the block, at the end of the run.",
      {{"cell_x", "",
        "Column of the cell in the block, from 0 at the clamp; of Laguerre cells, which stand in none, the "
        "place of the centroid over the mean width of a cell."},
       {"cell_y", "", "Row of the cell in the block, from 0 at the bottom."},
       {"displacement_x", "m",
        "Mean displacement of the cell's inside since the unloaded state, along x (away from the clamp)."},
       {"displacement_y", "m",
        "Mean displacement of the cell's inside since the unloaded state, along y (up)."}});
  return all;
}

Outputs tip_outputs(const bool with_table) {
  Outputs all;
  all.results({{"tip_displacement_x", "m",
                "Displacement of the middle of the side opposite to the clamp, at the end, along x (away "
                "from the clamp)."},
               {"tip_displacement_y", "m",
                "Displacement of the middle of the side opposite to the clamp, at the end, along y (up; the "
                "load acts down)."}});
  if (with_table)
    all.table("probe", "The middle of the side opposite to the clamp over time.",
              {{"time", "s", "Time since the load was put on."},
               {"displacement_x", "m",
                "Displacement of that point since the unloaded state along x, away from the clamp."},
               {"displacement_y", "m", "Displacement of that point since the unloaded state along y, up."}});
  return all;
}

Outputs block_outputs() {
  Outputs all;
  all.results(
      {{"width", "m", "Length of the block from the clamp to the free side, in the unloaded state."},
       {"density", "kg/m^3", "Mass of wall and fluid over the volume of a cell, in the unloaded state."},
       {"body_force", "m/s^2",
        "Size of the acceleration that acts on every mass: Load over (density times width)."}});
  return all;
}

std::vector<OutputDefinition> energy_columns() {
  return {{"potential", "J", "Potential energy of walls, fluid, contacts and plates together."},
          {"kinetic", "J", "Kinetic energy of all particles of wall and fluid."}};
}
}  // namespace turgor
