#include "micro/scenes/stokes/matrix_migration.h"

namespace turgor {
Outputs MatrixMigration::outputs() const {
  Outputs all;
  all.results(
         {{"particles", "", "Number of particles of the matrix."},
          {"steps", "", "Number of steps that were taken."},
          {"iterations_per_step", "1", "Iterations of conjugate gradients for one step, mean over the run."},
          {"end_time", "s", "Time at which the run ended: End time, or when the cell came to the rim."},
          {"displacement", "m", "Way of the cell along the preferred direction, from start to end."},
          {"speed", "m/s", "Displacement over the time of the run."},
          {"mean_force", "N/m",
           "Component of the driving force along the preferred direction, its mean over the run, per metre "
           "of "
           "depth."},
          {"compliance", "m^2/N", "Displacement over the mean force; 0 without a force."},
          {"mobility", "m^2/(N s)",
           "Speed along the preferred direction in the second half of End time, of a run that ended before "
           "in "
           "the whole of it, over the mean force; 0 without a force."},
          {"degraded_mobility", "m^2/(N s)",
           "The same in closed form where all of the matrix is degraded: of a disc midway between two "
           "plates, "
           "or in the middle of a round pool."},
          {"intact_compliance", "m^2/N",
           "Compliance in closed form of a round matrix that stays intact, at rest.", "with Domain = disc"},
          {"most_stress", "Pa", "Largest von Mises stress of any particle in any sample."},
          {"force_balance", "1",
           "Force on the rim less the driving force, over the driving force, mean of the samples: it has the "
           "stress at the start of its step and the friction at its end."},
          {"energy_balance", "1",
           "Stored energy, what degradation has released of it and heat, less work, over the larger of work "
           "and heat: what steps of finite length lose."}})
      .table("migration", "One row for each sample.",
             {{"time", "s", "Time since the run began."},
              {"x", "m", "Way of the cell along the preferred direction."},
              {"y", "m", "Way of the cell across it."},
              {"speed", "m/s", "Speed along the preferred direction, mean since the last sample."},
              {"force_x", "N/m", "Driving force along the preferred direction, per metre of depth."},
              {"force_y", "N/m", "Driving force across the preferred direction, per metre of depth."},
              {"rim_force_x", "N/m", "Force of the matrix on its rim along the preferred direction."},
              {"degraded_area", "m^2", "Area of matrix that is degraded, parts by their share."},
              {"most_stress", "Pa", "Largest von Mises stress of any particle."},
              {"work", "J/m", "Work of the driving force so far, per metre of depth."},
              {"heat", "J/m", "What friction has turned into heat so far."},
              {"stored", "J/m", "Elastic energy of the matrix."},
              {"released", "J/m", "Elastic energy that was lost with the matrix that was degraded so far."},
              {"iterations", "", "Iterations of conjugate gradients of the last step."}})
      .join(solid_fields());
  return all;
}
}  // namespace turgor
