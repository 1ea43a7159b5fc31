#include "micro/scenes/stokes/stokes_course.h"

#include "run/entry_marks.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/step_loop.h"

namespace turgor {
namespace {
/// Whether what happens `times` times until `end` (s) is due at `now`; `next` counts on here.
bool is_due(std::uint64_t &next, const unsigned int times, const double now, const double end) {
  const auto passed = [&] { return now >= end * double(next) / times * (1. - 1e-12); };
  if (times == 0 || !passed()) return false;
  while (passed()) ++next;
  return true;
}
}  // namespace

void StokesCourse::declare(InputEntries &prm, const std::string &table) {
  using namespace Patterns;
  prm.add_parameter("End time", end, "Time at which the run ends. Units: s.", Double(1e-12, 1e12));
  prm.add_parameter("Samples", samples,
                    free_to_change("Rows of " + table + ", spread evenly over the run. Units: none."),
                    Integer(1, 100000));
  prm.add_parameter("Frames", frames,
                    free_to_change("Frames of the fields, from the start to the end. Units: none."),
                    Integer(0, 10000));
  prm.add_parameter("Checkpoints", checkpoints,
                    free_to_change("Number of checkpoints spread over the run. Units: none."),
                    Integer(0, 10000));
}

void StokesCourse::steer(StepLoop &loop, At &at, const StokesFlow &flow) const {
  const auto due = [this, &flow](std::uint64_t &next, const unsigned int times) {
    return is_due(next, times, flow.time(), end);
  };
  loop.more = [this, &flow] { return flow.time() < end * (1. - 1e-12); };
  loop.sample_due = [this, &at, due] { return due(at.sample, samples); };
  loop.frame_due = [this, &at, due] { return due(at.frame, frames); };
  loop.checkpoint_due = [this, &at, due] { return due(at.saved, checkpoints); };
  loop.reached = [&flow] { return "at t = " + number_text(flow.time()) + " s"; };
  loop.share = [this, &flow] { return flow.time() / end; };
}
}  // namespace turgor
