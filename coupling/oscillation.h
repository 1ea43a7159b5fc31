// Amplitude and period of a tip that starts at rest, swings out and comes back, found
// while the run goes on: first maximum and the minimum after it, each refined by the
// parabola through three samples.
//
//   1 - exp(-d t) cos(w t):  first maximum near w t = pi, first return near w t = 2 pi
//
// An extremum counts once the signal has moved away from it by half a per cent of the largest value seen;
// smaller wiggles are not the tissue's own mode. Plain data: goes into checkpoints as it is.
// Units: t in s, y in any (m).
#pragma once

#include <algorithm>
#include <limits>

namespace turgor {
struct Extremum {
  double time = std::numeric_limits<double>::signaling_NaN();  ///< s
  double value = std::numeric_limits<double>::signaling_NaN();
};

class Oscillation {
 public:
  void add(double time, double value) {
    if (samples == 0) best = {time, value};
    t[0] = t[1];
    y[0] = y[1];
    t[1] = t[2];
    y[1] = y[2];
    t[2] = time;
    y[2] = value;
    ++samples;
    const double sign = found == 1 ? -1. : 1.;  // after the first maximum a minimum is looked for
    if (found > 1) return;
    if (sign * value > sign * best.value) best = {time, value};
    if (samples >= 3 && sign * y[1] >= sign * y[0] && sign * y[1] >= sign * y[2] &&
        sign * y[1] >= sign * best.value)
      best = vertex();
    largest = std::max(largest, found == 0 ? best.value : largest);
    if (sign * (best.value - value) > 0.005 * largest && largest > 0.) {
      (found == 0 ? first_maximum : first_return) = best;
      ++found;
      best = {time, value};
    }
  }

  bool has_maximum() const { return found >= 1; }
  bool has_return() const { return found >= 2; }
  const Extremum &maximum() const {
    return found == 0 ? best : first_maximum;
  }  ///< so far, if has_maximum() is false
  const Extremum &minimum() const { return first_return; }

 private:
  // Of the parabola through the last three samples.
  Extremum vertex() const {
    const double a = t[0] - t[1], b = t[2] - t[1];
    const double p = y[0] - y[1], q = y[2] - y[1];
    const double determinant = a * b * (a - b);
    const double curvature = (p * b - q * a) / determinant;
    if (!(curvature != 0.)) return {t[1], y[1]};
    const double slope = (q * a * a - p * b * b) / determinant;
    const double s = -slope / (2. * curvature);
    return {t[1] + s, y[1] + 0.5 * slope * s};
  }

  double t[3] = {0., 0., 0.}, y[3] = {0., 0., 0.};
  unsigned int samples = 0, found = 0;
  double largest = 0.;
  Extremum best, first_maximum, first_return;
};
}  // namespace turgor
