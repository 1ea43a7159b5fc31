// The point of a triangle nearest to a place, and on which of its features it lies (C. Ericson, Real-Time
// Collision Detection, 2005, 5.1.5).
//
// In: corners a, b, c and place p (m). Out: point (m); feature: inside, edge k (from corner k to k + 1) or
// corner k.
#pragma once

#include "micro/geometry/tensor.h"

namespace turgor {
struct ClosestPoint {
  enum On { inside, edge, corner };
  Vector<3> point = Vector<3>::Zero();
  On on = inside;
  int which = 0;  ///< edge or corner
};

inline ClosestPoint closest_point(const Vector<3> &p, const Vector<3> &a, const Vector<3> &b,
                                  const Vector<3> &c) {
  const Vector<3> ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0. && d2 <= 0.) return {a, ClosestPoint::corner, 0};
  const Vector<3> bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0. && d4 <= d3) return {b, ClosestPoint::corner, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0. && d1 >= 0. && d3 <= 0.) return {a + d1 / (d1 - d3) * ab, ClosestPoint::edge, 0};
  const Vector<3> cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0. && d5 <= d6) return {c, ClosestPoint::corner, 2};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0. && d2 >= 0. && d6 <= 0.) return {a + d2 / (d2 - d6) * ac, ClosestPoint::edge, 2};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0. && d4 - d3 >= 0. && d5 - d6 >= 0.)
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), ClosestPoint::edge, 1};
  const double all = 1. / (va + vb + vc);
  return {a + vb * all * ab + vc * all * ac, ClosestPoint::inside, 0};
}
}  // namespace turgor
