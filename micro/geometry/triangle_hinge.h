// The hinge of two triangles that share an edge a -> b: c is the third node of the one in which the edge runs
// so, d that of the other.
//
//   angle   between the outward normals n1, n2, by atan2 with the edge (errata B.7: with its sign), positive
//           where the surface is convex
//   d angle/dc = -|e| n1/|n1|^2, d angle/dd = -|e| n2/|n2|^2, of a and b what makes net force and torque of a
//     moment vanish
//
//   const TriangleHinge hinge(a, b, c, d);  Vector<3> g[4];  hinge.gradient(a, b, c, d, g);      positions in
//     m, angle in rad, g in 1/m
#pragma once

#include "micro/geometry/tensor.h"

#include <cmath>

namespace turgor {
/// Without the angle, which takes longest.
struct HingeSlope {
  Vector<3> e, n1, n2;  ///< n1, n2: twice the area times the normal
  double length, n1_squared, n2_squared;

  HingeSlope(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c, const Vector<3> &d)
      : e(b - a),
        n1(e.cross(c - a)),
        n2((d - b).cross(e)),
        length(e.norm()),
        n1_squared(n1.squaredNorm()),
        n2_squared(n2.squaredNorm()) {}

  /// d angle/d(a, b, c, d), 1/m
  void gradient(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c, const Vector<3> &d,
                Vector<3> g[4]) const {
    const Vector<3> m1 = n1 / n1_squared, m2 = n2 / n2_squared;
    const double inverse = 1. / length;
    g[2] = -length * m1;
    g[3] = -length * m2;
    g[0] = (b - c).dot(e) * inverse * m1 + (b - d).dot(e) * inverse * m2;
    g[1] = (c - a).dot(e) * inverse * m1 + (d - a).dot(e) * inverse * m2;
  }

  /// sin and cos of the angle times |n1| |n2|, m^4
  double sine() const { return n1.cross(n2).dot(e) / length; }
  double cosine() const { return n1.dot(n2); }
};

struct TriangleHinge : HingeSlope {
  double angle;

  TriangleHinge(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c, const Vector<3> &d)
      : HingeSlope(a, b, c, d) {
    angle = std::atan2(sine(), cosine());
  }
};
}  // namespace turgor
