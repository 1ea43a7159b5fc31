// The line through samples (x, u), x rising: its value and its integral. interpolated({0, 2}, {1, 3}, 0.5)
// is 1.5.
#pragma once

#include <vector>

namespace turgor {
/// Constant beyond the ends.
double interpolated(const std::vector<double> &x, const std::vector<double> &u, double at);

/// int u dx from a to b.
double integral(const std::vector<double> &x, const std::vector<double> &u, double a, double b);
}  // namespace turgor
