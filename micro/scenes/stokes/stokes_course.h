// How long a run of a Stokes flow is and what it leaves on the way: rows, frames and checkpoints, each evenly
// spread over its time, in steps of any length.
//
//   StokesCourse course{.end = 0.5};   course.declare(prm, "flow.csv");
//   course.steer(loop, at, flow);      what is due when; advance, sample, frame, tell are the scene's
#pragma once

#include "micro/scenes/stokes/stokes_flow.h"

#include <cstdint>
#include <string>

namespace turgor {
class StepLoop;

struct StokesCourse {
  double end;  ///< s
  unsigned int samples = 100, frames = 4, checkpoints = 4;

  /// What of it has been, plain data of a checkpoint: numbers of the next ones, from 1 on.
  struct At {
    std::uint64_t step = 0, sample = 1, frame = 1, saved = 1;
  };

  /// End time, Samples, Frames, Checkpoints; table: of the rows.
  void declare(InputEntries &prm, const std::string &table);
  /// When the loop ends and what is due; all three have to outlive it.
  void steer(StepLoop &loop, At &at, const StokesFlow &flow) const;
};
}  // namespace turgor
