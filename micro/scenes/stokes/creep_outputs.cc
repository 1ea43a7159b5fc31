#include "micro/scenes/stokes/creep.h"

namespace turgor {
Outputs Creep::outputs() const {
  Outputs all;
  all.results(
         {{"particles", "", "Number of particles of the slab."},
          {"steps", "", "Number of steps that were taken."},
          {"iterations_per_step", "1", "Iterations of conjugate gradients for one step, mean over the run."},
          {"delay", "s", "Time in which all but 1/e of the creep has happened, in the closed form."},
          {"profile_error", "1",
           "Root of the mean square of the particles' displacement along the load less that of the closed "
           "form, over that of the closed form at last; at the end."},
          {"profile_error_worst", "1", "The same, the largest of all samples."},
          {"plate_stress_error_worst", "1",
           "What the plate feels over the slab's weight, less one: the largest of all samples."},
          {"energy_balance", "1",
           "Stored energy and heat less work, over the larger of work and heat: what steps of finite length "
           "lose."}})
      .table(
          "creep", "One row for each sample.",
          {{"time", "s", "Time since the load began."},
           {"top", "m", "Displacement of the uppermost layer of particles along the load, its mean."},
           {"exact_top", "m", "The same in the closed form."},
           {"profile_error", "1",
            "Root of the mean square of the particles' displacement less that of the closed form, over that "
            "of the closed form at last."},
           {"plate_stress", "Pa", "Force along the load on the plate, over its area."},
           {"weight", "Pa", "Weight of the slab over the area of its plate."},
           {"work", "J/m", "Work of the weight so far."},
           {"heat", "J/m", "What friction has turned into heat so far."},
           {"stored", "J/m", "Elastic energy of the slab so far."},
           {"iterations", "", "Iterations of conjugate gradients of the last step."}})
      .table("profile", "A row for each layer of particles, in each frame.",
             {{"time", "s", "Time since the load began.", "with Frames"},
              {"height", "m", "Height of the layer over the plate, as it was laid.", "with Frames"},
              {"displacement", "m", "Its mean displacement along the load.", "with Frames"},
              {"exact_displacement", "m", "The same in the closed form.", "with Frames"}})
      .join(solid_fields());
  return all;
}

}  // namespace turgor
