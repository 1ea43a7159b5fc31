// The tissue cannot be moved on: which point, where, when and why. The committed state is untouched.
#pragma once

#include <array>
#include <stdexcept>
#include <string>

namespace turgor {
/// A point at which no stress could be found; recoverable by a shorter step.
struct TissueFailure {
  unsigned int element = 0, point = 0;  ///< point: index in the law's batch
  std::array<double, 3> position = {};  ///< m, reference
  std::string reason;                   ///< a sentence
  unsigned int others = 0;              ///< further points that failed in the same batch

  std::string describe() const;
};

class TissueFailed : public std::runtime_error {
 public:
  /// time: s, of the last committed state; step: s, the shortest that was tried.
  TissueFailed(const TissueFailure &failure, double time, double step, unsigned int halvings);

  const TissueFailure failure;
  const double time;
};
}  // namespace turgor
