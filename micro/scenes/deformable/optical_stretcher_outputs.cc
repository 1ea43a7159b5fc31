#include "micro/scenes/deformable/optical_stretcher.h"

namespace turgor {
Outputs OpticalStretcher::outputs() const {
  const char *with_kelvin_voigt = "with Kelvin-Voigt edges";
  Outputs all;
  all.results({{"long_axis_*", "1",
                "Change of the cell's extent along the beams when the light goes off, over that at rest; one "
                "result for each kind of edges and power."},
               {"short_axis_*", "1",
                "Change of the mean of the cell's extents along x and y, across the beams, when the light "
                "goes off, over that at rest; one result for each kind of edges and power."},
               {"stays_*", "1",
                "Change of the long axis at the end over that when the light went off: 0 where the cell has "
                "come back, 1 where all of it stays."},
               {"recovery_rate_*", "1/s",
                "Rate at which the long axis comes back: minus the slope of ln(long_axis) over time by least "
                "squares over the samples of the second half of the time without light.",
                "where the cell is still longer than at rest in at least two of them"},
               {"at_rest_*", "1",
                "Closed form of the long axis' change where nothing rubs any more: thin shell of an "
                "isotropic net around incompressible content, small strain (about 2.5 times the strain, of "
                "itself, too large), no bending; the short axis has minus half of it.",
                with_kelvin_voigt},
               {"nodes", "", "Number of nodes of the cell's surface."},
               {"steps", "", "Number of steps of all runs."},
               {"energy_balance", "1",
                "Work of the light less what is stored and what became heat, over the larger of work and "
                "heat: the largest of the runs; what steps of finite length lose."}})
      .table(
          "axes", "One row a sample of each run; runs one after the other.",
          {{"run", "", "Number of the run, from 0: Kelvin-Voigt edges first, and in each kind by Powers."},
           {"power", "W", "Power of each beam in this run while the light is on."},
           {"modified_maxwell", "",
            "1 where the edges of this run are modified Maxwell elements, 0 for Kelvin-Voigt."},
           {"time", "s", "Time since the light went on."},
           {"long_axis", "1", "Change of the cell's extent along the beams, over that at rest."},
           {"short_axis", "1",
            "Change of the mean of the cell's extents along x and y, across the beams, over that at rest."},
           {"volume", "m^3", "Volume that the surface encloses."},
           {"pressure", "Pa", "Pressure inside over that outside."},
           {"elastic", "J", "Elastic energy less that at the start of the run."},
           {"work", "J", "Work of the light since the start of the run."},
           {"heat_medium", "J",
            "Energy that friction with the medium has turned into heat since the start of the run."},
           {"heat_cortex", "J",
            "Energy that dashpots and flow of the edges have turned into heat since the start of the run."}})
      .fields("surface",
              "The cell's surface as triangles: at rest, and of each run when the light goes off and at its "
              "end; times count on from run to run.",
              {{"in_plane_stress", "N/m",
                "In-plane stress of the net of edges at each node, positive in tension (B.5).",
                "with Fields = true"}});
  return all;
}
}  // namespace turgor
