// Volume, middle and second moments of the homogeneous solid inside a closed surface of triangles, exactly:
// sums over the tetrahedra that the triangles make with one point.
//
//   integral of x x^T over a tetrahedron 0, a, b, c:   det/120 (a a^T + b b^T + c c^T + s s^T), s = a + b + c
//
// Inertia about the middle: J = density (tr C I - C), C the second moments there.
#pragma once

#include "micro/geometry/triangle_mesh.h"

#include <Eigen/Geometry>

namespace turgor {
struct SolidInertia {
  double volume = 0.;                         ///< m^3
  Vector<3> middle = Vector<3>::Zero();       ///< m, centre of mass
  Tensor2<3> moments = Tensor2<3>::Zero();    ///< m^5, C
  Tensor2<3> inertia(double density) const {  ///< kg m^2, J
    return density * (moments.trace() * Tensor2<3>::Identity() - moments);
  }
};

/// nodes: m; triangles counter-clockwise seen from outside.
inline SolidInertia solid_inertia(const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes) {
  SolidInertia solid;
  const Vector<3> from = nodes[0];  // near the body: no digits are lost where it is far from the origin
  Vector<3> first = Vector<3>::Zero();
  for (const auto &f : mesh.faces) {
    const Vector<3> a = nodes[f[0]] - from, b = nodes[f[1]] - from, c = nodes[f[2]] - from, s = a + b + c;
    const double det = a.dot(b.cross(c));
    solid.volume += det / 6.;
    first += det / 24. * s;
    solid.moments +=
        det / 120. * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  const Vector<3> away = first / solid.volume;
  solid.moments -= solid.volume * away * away.transpose();
  solid.middle = from + away;
  return solid;
}
}  // namespace turgor
