#include "micro/scenes/deformable/rbc_tweezers.h"

namespace turgor {
Outputs RbcTweezers::outputs() const {
  const char *compared = "with an Experiment", *written = "with Fields = true";
  Outputs all;
  all.results(
         {{"nodes", "", "Number of nodes of the cell's surface."},
          {"steps", "", "Number of steps that were taken."},
          {"axial_diameter", "m", "Extent of the cell along the forces at the largest of Forces."},
          {"transverse_diameter", "m",
           "Extent of the cell across the forces, in the plane of the disc, at the largest of Forces."},
          {"energy_balance", "1",
           "Work of the tweezers less what is stored and what became heat, over the larger of work and heat; "
           "what steps of finite length lose."},
          {"points_compared", "", "Number of measured diameters with a range up to the largest of Forces.",
           compared},
          {"points_outside", "", "Number of those diameters whose range the computed one is outside of.",
           compared},
          {"largest_deviation", "1",
           "Largest deviation of a computed diameter from the measured mean, over that mean.", compared}})
      .table(
          "history", "One row a sample, and one at the end.",
          {{"time", "s", "Time since the force began to rise."},
           {"force", "N", "Force that pulls at each end."},
           {"axial_diameter", "m", "Extent of the cell along the forces."},
           {"transverse_diameter", "m", "Extent of the cell across the forces, in the plane of the disc."},
           {"thickness", "m", "Extent of the cell along the axis of the disc."},
           {"volume", "m^3", "Volume that the surface encloses."},
           {"area", "m^2", "Area of the cell's surface."},
           {"pressure", "Pa", "Pressure inside over that outside."},
           {"elastic", "J", "Elastic energy less that at the start."},
           {"work", "J", "Work of the forces since the start."},
           {"heat_medium", "J", "Energy that friction with the medium has turned into heat since the start."},
           {"heat_cortex", "J",
            "Energy that the dashpots of the edges have turned into heat since the start."}})
      .table(
          "diameters",
          "One row for the cell at rest and one for each of Forces, at the end of its Hold time.",
          {{"force", "N", "Force that pulls at each end."},
           {"axial_diameter", "m", "Extent of the cell along the forces."},
           {"transverse_diameter", "m", "Extent of the cell across the forces, in the plane of the disc."},
           {"thickness", "m", "Extent of the cell along the axis of the disc."},
           {"largest_speed", "m/s", "Speed of the fastest node, which tells how far the cell is from rest."}})
      .table("comparison", "One row for each measured diameter that has a range.",
             {{"transverse", "", "0 for the axial diameter, 1 for the transverse one.", compared},
              {"force", "N", "Force that pulls at each end.", compared},
              {"computed", "m", "Diameter of this run, between its Forces by straight lines.", compared},
              {"measured", "m", "Mean of the measured diameters.", compared},
              {"low", "m", "Lower end of the range that was measured.", compared},
              {"high", "m", "Upper end of the range that was measured.", compared},
              {"inside", "", "1 where the computed diameter is within that range, 0 where not.", compared}})
      .fields("surface", "The cell's surface as triangles, at rest and at each of Forces.",
              {{"in_plane_stress", "N/m",
                "In-plane stress of the net of edges at each node, positive in tension (B.5).", written}});
  return all;
}
}  // namespace turgor
