// What scenes of many steps share beside their physics: the reference cell they start from, how often
// something is done, and saving or stopping after a step.
#pragma once

#include "micro/cells/sph_parenchyma.h"

#include <cstdint>
#include <functional>
#include <string>

namespace turgor
{
class RunContext;

/// The annealed cell, with progress shown. Throws RunStopped: there is nothing to save yet, a resumed run anneals again.
ReferenceCell anneal_reference(RunContext &context, const ParenchymaParameters &cell, const SphParameters &sph);

/// Steps from one time to the next, so that something happens `times` in `steps` steps; at least 1, and 0 for never.
std::uint64_t steps_between(std::uint64_t steps, std::uint64_t times);

/// Checkpoints spread evenly over a run, and one more where somebody asks it to stop.
class StepCheckpoints
{
public:
  /// reached: where the run is, as "at t = 1 ms".
  StepCheckpoints(RunContext &context, std::uint64_t last_step, unsigned int count, std::function<void()> save,
                  std::function<std::string()> reached);

  /// To be called at the end of every step. Throws RunStopped, once all is saved.
  void after_step(std::uint64_t step) const;

  /// Saves and throws RunStopped.
  [[noreturn]] void stop() const;

private:
  RunContext &context;
  std::uint64_t last, every;
  std::function<void()> save;
  std::function<std::string()> reached;
};
} // namespace turgor
