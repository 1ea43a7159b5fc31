// Bisection whose ends are tested: what it returns is where the answer changes, never an end of the bracket.
//
//   const double x = bisect(low, high, [](double y) { return y * y < 2.; }, "the square root of 2");
#pragma once

#include "run/number_text.h"

#include <stdexcept>
#include <string>

namespace turgor {
/// below(low) has to be true and below(high) false; halves the interval `halvings` times, or until nothing
/// lies between. Throws std::runtime_error saying that `what` does not lie between the two where they are
/// not.
template <class Predicate>
double bisect(double low, double high, const Predicate &below, const std::string &what,
              const int halvings = 200) {
  if (!below(low) || below(high))
    throw std::runtime_error(what + " does not lie between " + number_text(low) + " and " +
                             number_text(high) + ", where it is sought");
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low) || !(middle < high)) break;
    (below(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}
}  // namespace turgor
