// What a run says about the worth of its own results: a note in summary.json and a line at the terminal where
// a number has grown beyond a stated share, a failure where the results mean nothing.
//
//   judged(context, "energy_balance", error, {0.02, 0.1}, "energy of 3 % of the plates' work is not found
//     again");
#pragma once

#include "run/number_text.h"
#include "run/run_context.h"

#include <cmath>
#include <string>

namespace turgor {
struct Shares {
  double noted, allowed;  ///< above the first a note, above the second a failure; HUGE_VAL: never
};

/// To whoever reads summary.json and to whoever looks at the terminal.
inline void remarked(RunContext &context, const std::string &name, const std::string &text) {
  context.note(name, text);
  context.say(text);
}

/// sentence: without a full stop. Throws RunFailed.
inline void judged(RunContext &context, const std::string &name, const double value, const Shares &shares,
                   const std::string &sentence) {
  const double size = std::abs(value);
  if (!(size <= shares.allowed))
    throw RunFailed(sentence + ", more than the " + number_text(100. * shares.allowed) +
                    " % beyond which the results mean nothing.");
  if (size <= shares.noted) return;
  remarked(
      context, name,
      sentence + ", more than the " + number_text(100. * shares.noted) + " % beyond which a run says so.");
}

/// Of fluid particles outside a wall that is whole, over all of them. Measured on struck tissue against finer
/// particles (doc/design_notes.md, "When a run fails over its own results").
constexpr Shares shares_outside{0.01, 0.04};

/// What every scene with fluid in closed walls says of most_crossed, the particles that it found outside;
/// nothing without fluid. advice: what keeps them in.
inline void judge_outside(RunContext &context, const double crossed, const double fluid_particles,
                          const std::string &advice) {
  if (fluid_particles > 0.)
    judged(context, "most_crossed", crossed / fluid_particles, shares_outside,
           number_text(100. * crossed / fluid_particles) +
               " % of the fluid particles are outside a wall that is whole (" + advice + ")");
}
}  // namespace turgor
