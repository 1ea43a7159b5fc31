#include "run/step_loop.h"

#include "run/judged.h"

#include <algorithm>

namespace turgor {
std::uint64_t steps_between(const std::uint64_t steps, const std::uint64_t times) {
  return times > 0 ? std::max<std::uint64_t>(1, steps / times) : 0;
}

StepLoop::StepLoop(RunContext &context_, std::uint64_t &step_)
    : save([this] {
        if (check) check();
        context.save_checkpoint(lasting);
      }),
      context(context_),
      step(step_) {}

void StepLoop::spread(const std::uint64_t last, const std::uint64_t steps, const unsigned int samples,
                      const unsigned int frames, const unsigned int checkpoints) {
  const auto every = [this](const std::uint64_t n) { return [this, n] { return n > 0 && step % n == 0; }; };
  more = [this, last] { return step < last; };
  sample_due = every(steps_between(steps, samples));
  frame_due = every(steps_between(steps, frames));
  checkpoint_due = every(checkpoints > 0 ? steps_between(last, std::uint64_t(checkpoints) + 1) : 0);
}

void StepLoop::begin() const {
  if (sample) sample();
  if (frame) frame();
}

void StepLoop::run() {
  while (more()) {
    advance();
    ++step;
    look();
    if (sample && sample_due()) sample();
    if (frame && frame_due()) frame();
    if (tell && step % tell_every == 0) tell();
    if (!more()) return;
    if (context.stop_requested()) stop();
    if (checkpoint_due && checkpoint_due()) save();
  }
}

void StepLoop::look() {
  if (!share) return;
  if (const std::string far = sight.after_step(share()); !far.empty())
    remarked(context, "no_end_in_sight", reached() + " " + far + ". " + advice);
}

void StepLoop::stop() const {
  save();
  throw RunStopped("stopped " + reached() + "; --resume goes on from there");
}
}  // namespace turgor
