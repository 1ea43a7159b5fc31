// More energy can be turned to heat and used up than loads and plates have put in: turgor has stretched the
// walls before they did anything.
#pragma once

#include "run/number_text.h"
#include "run/run_context.h"

#include <string>

namespace turgor {
/// taken: by viscosity, flow and breaking together. Only for scenes whose walls have yielded or broken;
/// silent where the work was enough.
inline void tell_of_stored_turgor(RunContext &context, const double taken, const double work,
                                  const std::string &unit) {
  if (taken > work)
    context.say("Heat, flow and breaking have taken " + number_text(taken, 3) + " " + unit +
                ", more than the work of " + number_text(work, 3) + " " + unit +
                ": walls that yielded or broke have also set free what turgor had stored in them before.");
}
}  // namespace turgor
