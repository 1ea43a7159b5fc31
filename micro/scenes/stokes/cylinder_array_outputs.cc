#include "micro/scenes/stokes/cylinder_array.h"

namespace turgor {
Outputs CylinderArray::outputs() const {
  const std::string window = " mean over the samples of the second half of the run.";
  Outputs all;
  all.results(
         {{"particles", "", "Number of fluid particles in a period."},
          {"steps", "", "Number of steps that were taken."},
          {"iterations_per_step", "1", "Iterations of conjugate gradients for one step, mean over the run."},
          {"exact_drag", "1",
           "Exact force on a metre of cylinder, with that of the mean gradient of pressure, over "
           "viscosity and superficial speed."},
          {"drag", "1", "The same of the particles' mean velocity under the body force," + window},
          {"drag_error", "1", "That drag over the exact one, less 1."},
          {"drag_error_worst", "1",
           "The same without sign, the largest of the samples of the second half of the run."},
          {"momentum_balance", "1",
           "Body force on all fluid less the force on the cylinder, over the former: the largest of the "
           "samples of the second half, without sign."},
          {"energy_balance", "1",
           "What is stored and turned into heat less the work of the body force, over the larger of "
           "work and heat, at the end: what steps of finite length miss."}})
      .table("drag", "One row a sample.",
             {{"time", "s", "Time since the fluid was at rest."},
              {"drag", "1", "Drag over viscosity and superficial speed by the particles' mean velocity."},
              {"drag_error", "1", "The same over the exact one, less 1."},
              {"speed", "m/s", "Superficial speed, mean over fluid and cylinders."},
              {"cylinder_force", "N/m",
               "Force of the fluid on the cylinder along x, without that of the mean gradient of pressure."},
              {"driving_force", "N/m", "Body force on all of the fluid of a period."},
              {"work", "J/m", "Work of the body force since the start, per metre of depth."},
              {"heat", "J/m", "Heat since the start, per metre of depth."},
              {"stored", "J/m", "Energy of pressure less that at the start, per metre of depth."},
              {"iterations", "", "Iterations of conjugate gradients for the last step."}})
      .fields("fluid", "The particles, in the first period.",
              {{"velocity", "m/s", "Velocity of each particle in the last step.", "with Frames"},
               {"pressure", "Pa", "Pressure of each particle by the equation of state.", "with Frames"}});
  return all;
}
}  // namespace turgor
