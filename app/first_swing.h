// The first swing of something out of rest: how far it goes and when it is back, so that a study can tell an
// error of amplitude from an error of period.
#pragma once

#include <optional>
#include <vector>

namespace turgor {
struct Swing {
  double amplitude = 0.;         ///< largest value, signed
  double time_of_largest = 0.;   ///< of the abscissa
  std::optional<double> period;  ///< where it turns round again; nothing when the history ends before
};

/// Of values u over ascending times t. Extrema are those of the parabola through the three samples about the
/// largest (smallest) one. Throws std::runtime_error when there are fewer than three samples or nothing
/// moves.
Swing first_swing(const std::vector<double> &t, const std::vector<double> &u);
}  // namespace turgor
