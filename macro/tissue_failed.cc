#include "macro/tissue_failed.h"

#include <sstream>

namespace turgor {
std::string TissueFailure::describe() const {
  std::ostringstream text;
  text << "element " << element << ", quadrature point " << point << " at (" << position[0] << ", "
       << position[1] << ", " << position[2] << ") m: " << reason;
  if (others > 0) text << " (and " << others << " more points)";
  return text.str();
}

namespace {
std::string sentence(const TissueFailure &failure, double time, double step, unsigned int halvings) {
  std::ostringstream text;
  text << "The tissue cannot be moved on from t = " << time << " s: " << failure.describe()
       << ". The step was halved " << halvings << " times, to " << step << " s.";
  return text.str();
}
}  // namespace

TissueFailed::TissueFailed(const TissueFailure &failure_, double time_, double step, unsigned int halvings)
    : std::runtime_error(sentence(failure_, time_, step, halvings)), failure(failure_), time(time_) {}
}  // namespace turgor
