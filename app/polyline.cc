#include "app/polyline.h"

#include <algorithm>

namespace turgor {
double interpolated(const std::vector<double> &x, const std::vector<double> &u, const double at) {
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return u.front();
  if (above == x.end()) return u.back();
  const auto i = static_cast<std::size_t>(above - x.begin());
  return u[i - 1] + (at - x[i - 1]) / (x[i] - x[i - 1]) * (u[i] - u[i - 1]);
}

double integral(const std::vector<double> &x, const std::vector<double> &u, const double a, const double b) {
  double sum = 0., left = a, at_left = interpolated(x, u, a);
  for (std::size_t i = 0; i < x.size() && left < b; ++i)
    if (x[i] > a) {
      // A jump is two samples at one place: each side has its own value there.
      const double right = std::min(x[i], b), at_right = x[i] <= b ? u[i] : interpolated(x, u, b);
      sum += 0.5 * (right - left) * (at_left + at_right);
      left = right;
      at_left = at_right;
    }
  return sum + std::max(0., b - left) * at_left;
}
}  // namespace turgor
