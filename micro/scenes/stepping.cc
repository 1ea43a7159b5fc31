#include "micro/scenes/stepping.h"

#include "micro/cells/turgid_reference.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <utility>

namespace turgor
{
ReferenceCell anneal_reference(RunContext &context, const ParenchymaParameters &cell, const SphParameters &sph)
{
  context.say("annealing the reference cell (" + number_text(sph.anneal_steps) + " steps)");
  return make_turgid_reference(cell, sph, [&](const double fraction) {
    context.progress(fraction, "annealing");
    if (context.stop_requested())
      throw RunStopped("stopped while the reference cell was annealed");
  });
}

std::uint64_t steps_between(const std::uint64_t steps, const std::uint64_t times)
{
  return times > 0 ? std::max<std::uint64_t>(1, steps / times) : 0;
}

StepCheckpoints::StepCheckpoints(RunContext &context_, const std::uint64_t last_step, const unsigned int count,
                                 std::function<void()> save_, std::function<std::string()> reached_)
  : context(context_)
  , last(last_step)
  , every(count > 0 ? steps_between(last_step, std::uint64_t(count) + 1) : 0) // none at the end
  , save(std::move(save_))
  , reached(std::move(reached_))
{}

void StepCheckpoints::after_step(const std::uint64_t step) const
{
  if (context.stop_requested())
    stop();
  if (every > 0 && step % every == 0 && step < last)
    save();
}

void StepCheckpoints::stop() const
{
  save();
  throw RunStopped("stopped " + reached() + "; --resume goes on from there");
}
} // namespace turgor
