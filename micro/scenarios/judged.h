// What a run says about the worth of its own results: a note in summary.json and a line at the terminal where a number has grown
// beyond a stated share, a failure where the results mean nothing.
//
//   judged(context, "energy_balance", error, {0.02, 0.1}, "energy of 3 % of the plates' work is not found again");
#pragma once

#include "micro/io/number_text.h"
#include "micro/io/run_context.h"

#include <cmath>
#include <string>

namespace turgor
{
struct Shares
{
  double noted, allowed; ///< above the first a note, above the second a failure; HUGE_VAL: never
};

/// sentence: without a full stop. Throws RunFailed.
inline void judged(RunContext &context, const std::string &name, const double value, const Shares &shares, const std::string &sentence)
{
  const double size = std::abs(value);
  if (!(size <= shares.allowed))
    throw RunFailed(sentence + ", more than the " + number_text(100. * shares.allowed) + " % beyond which the results mean nothing.");
  if (size <= shares.noted)
    return;
  const std::string text = sentence + ", more than the " + number_text(100. * shares.noted) + " % beyond which a run says so.";
  context.note(name, text);
  context.say(text);
}
} // namespace turgor
