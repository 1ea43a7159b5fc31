// Where two segments are nearest to each other (C. Ericson, Real-Time Collision Detection, 2005, 5.1.9);
// either may be a point. Of parallel ones that lie beside each other the middle of what they share.
//
//   const ClosestSegments c = closest_segments(a, b, p, q);   a + s (b - a), p + t (q - p)
//
// In: ends (m). Out: s, t in [0, 1].
#pragma once

#include "micro/geometry/tensor.h"

#include <algorithm>

namespace turgor {
struct ClosestSegments {
  double s = 0.5, t = 0.5;
};

inline ClosestSegments closest_segments(const Vector<3> &a, const Vector<3> &b, const Vector<3> &p,
                                        const Vector<3> &q) {
  const Vector<3> u = b - a, v = q - p, w = a - p;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const auto held = [](const double x) { return std::clamp(x, 0., 1.); };
  constexpr double point = 1e-24, parallel = 1e-12;
  const bool first_is_point = !(uu > point * vv), second_is_point = !(vv > point * uu);
  if (first_is_point && second_is_point) return {};
  if (first_is_point) return {0.5, held(vw / vv)};
  if (second_is_point) return {held(-uw / uu), 0.5};
  const double crossing = uu * vv - uv * uv;
  double s;
  if (crossing > parallel * uu * vv) {
    s = held((uv * vw - uw * vv) / crossing);
  } else {  // the ends of the other one along this
    const double from = -uw / uu, to = from + uv / uu;
    s = 0.5 * (held(std::min(from, to)) + held(std::max(from, to)));
  }
  double t = (uv * s + vw) / vv;
  if (t < 0. || t > 1.) {
    t = held(t);
    s = held((uv * t - uw) / uu);
  }
  return {s, t};
}
}  // namespace turgor
