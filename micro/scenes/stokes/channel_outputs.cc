#include "micro/scenes/stokes/channel.h"

namespace turgor {
Outputs Channel::outputs() const {
  const std::string window = " mean over the samples of the second half of the run.";
  Outputs all;
  all.results(
         {{"particles", "", "Number of fluid particles between the plates."},
          {"steps", "", "Number of steps that were taken."},
          {"iterations_per_step", "1", "Iterations of conjugate gradients for one step, mean over the run."},
          {"mean_neighbours", "1",
           "Particles within the kernel's support of a particle, mean over all at the end."},
          {"profile_error_at_start", "1",
           "Root of the mean square of the particles' velocity along the plates less the exact one, over "
           "that of "
           "the exact one, in the first step: of the packing as it was laid."},
          {"profile_error", "1", "The same," + window},
          {"profile_error_worst", "1", "The same, the largest of all samples."},
          {"across", "1",
           "Root of the mean square of the particles' velocity across the channel, which is none in the "
           "exact "
           "flow, over that of the exact velocity along it," +
               window},
          {"flux_error", "1",
           "Mean velocity of the particles over the mean of the exact one at their places, less 1," + window},
          {"stress_error", "1",
           "What the fluid drags the lower plate along with, less the exact stress at that time, over the "
           "exact "
           "steady one," +
               window},
          {"stress_error_worst", "1", "The same without sign, the largest of all samples."},
          {"dissipation_over_power", "1",
           "What friction turns into heat over the power of body force and upper plate," + window},
          {"momentum_balance", "1",
           "Body force less the drag on both plates and what momentum is gained, over the largest of them: "
           "the "
           "largest of all samples, without sign; what the stiffness of implicit steps and the solver "
           "leave."},
          {"energy_balance", "1",
           "What is stored and turned into heat less the work of body force and upper plate, over the larger "
           "of "
           "work and heat, at the end: what steps of finite length miss."}})
      .table(
          "flow", "One row a sample.",
          {{"time", "s", "Time since the fluid was at rest."},
           {"profile_error", "1",
            "Root of the mean square of the particles' velocity along the plates less the exact one, over "
            "that "
            "of the exact one."},
           {"across", "1",
            "Root of the mean square of the particles' velocity across the channel over that of the exact "
            "one along it."},
           {"flux_error", "1",
            "Mean velocity of the particles over the mean of the exact one at their places, less 1."},
           {"mean_velocity", "m/s", "Mean velocity of the particles along the plates."},
           {"lower_stress", "Pa", "Force of the fluid on the lower plate along x, over its area."},
           {"upper_stress", "Pa", "Force of the fluid on the upper plate along x, over its area."},
           {"exact_lower_stress", "Pa", "The exact stress on the lower plate at this time."},
           {"momentum_balance", "1",
            "Body force less the drag on both plates and what momentum is gained, over the largest of them."},
           {"power", "W/m", "Power of body force and upper plate in the step, per metre of depth."},
           {"dissipation", "W/m", "What friction turns into heat in the step, per metre of depth."},
           {"work", "J/m", "Work of body force and upper plate since the start, per metre of depth."},
           {"heat", "J/m", "Heat since the start, per metre of depth."},
           {"stored", "J/m",
            "Energy of pressure, and of motion where there is inertia, less that at the start, one step ago, "
            "per metre of depth."},
           {"iterations", "", "Iterations of conjugate gradients for the last step."}})
      .table("profile", "One row a layer of particles, one spacing high, of each frame.",
             {{"time", "s", "Time since the fluid was at rest.", "with Frames"},
              {"height", "m", "Mean height of the layer's particles over the lower plate.", "with Frames"},
              {"speed", "m/s", "Mean velocity of the layer's particles along the plates.", "with Frames"},
              {"exact_speed", "m/s", "The exact velocity at that height and time.", "with Frames"}})
      .fields("fluid", "The particles, in the first period.",
              {{"velocity", "m/s", "Velocity of each particle in the last step.", "with Frames"},
               {"pressure", "Pa", "Pressure of each particle by the equation of state.", "with Frames"}});
  return all;
}
}  // namespace turgor
