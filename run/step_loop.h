// The loop of every scene that goes in steps: one step, and after it what is due: a row of the tables, a
// frame, progress, a wish to stop, a checkpoint. It knows no physics.
//
//   StepLoop loop(context, at.step);
//   loop.spread(last, samples, frames, checkpoints);
//   loop.advance = [&] { integrator.step(at.dt); };
//   loop.sample = [&] { require_sound(...); table->add_row(...); };
//   loop.lasting = [&](Archive &a) { a(at, system, integrator); };
//   loop.reached = [&] { return "at t = " + number_text(at.time()) + " s"; };
//   loop.share = [&] { return at.time() / end; };
//   loop.advice = "A smaller Cell/Wall stiffness lengthens them.";
//   const bool resumed = context.load_checkpoint(loop.lasting);
//   if (!resumed)
//     loop.begin();
//   loop.run();
//
// What is due goes by the number of steps taken, which is in the checkpoint, or by what a scene says instead.
#pragma once

#include "run/end_in_sight.h"

#include <cstdint>
#include <functional>
#include <string>

namespace turgor {
class Archive;
class RunContext;

/// Steps from one time to the next, so that something happens `times` in `steps` steps; at least 1, and 0 for
/// never.
std::uint64_t steps_between(std::uint64_t steps, std::uint64_t times);

class StepLoop {
 public:
  /// step: taken so far; counted on here.
  StepLoop(RunContext &context, std::uint64_t &step);
  StepLoop(const StepLoop &) = delete;

  std::function<void()> advance;           ///< one step; throws where it cannot be taken
  std::function<void(Archive &)> lasting;  ///< what a checkpoint holds
  std::function<std::string()> reached;    ///< where the run is, as "at t = 1 ms"
  std::function<void()>
      check;  ///< before each checkpoint: throws RunFailed where nothing of the state is worth keeping
  std::function<void()> save;  ///< a checkpoint; made of check and lasting where a scene sets no other
  std::function<void()> sample,
      frame;                   ///< a row of the tables, which checks the state; a frame of the fields
  std::function<void()> tell;  ///< progress

  /// Of the run that lies behind, in [0, 1]: where no end is in sight (end_in_sight.h) the run says so, with
  /// `advice`, a sentence of what makes its steps longer or fewer.
  std::function<double()> share;
  std::string advice;

  std::function<bool()> more;                                   ///< whether the run goes on
  std::function<bool()> sample_due, frame_due, checkpoint_due;  ///< after a step
  std::uint64_t tell_every = 16;                                ///< steps

  /// A run of `last` steps, in `steps` of which there are so many samples, frames and checkpoints, spread
  /// evenly; none of the latter at the end.
  void spread(std::uint64_t last, std::uint64_t steps, unsigned int samples, unsigned int frames,
              unsigned int checkpoints);

  /// The first sample and frame, of a run that does not go on from a checkpoint.
  void begin() const;
  /// Until there is no more. Throws RunStopped, once all is saved.
  void run();

  /// After each step: whether an end is in sight. Called by run(); a scene whose one step lasts long calls it
  /// inside.
  void look();

  /// Saves and throws RunStopped.
  [[noreturn]] void stop() const;

 private:
  RunContext &context;
  std::uint64_t &step;
  EndInSight sight;
};
}  // namespace turgor
