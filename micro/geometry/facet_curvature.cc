#include "micro/geometry/facet_curvature.h"

#include <Eigen/Geometry>

#include <cmath>

namespace turgor {
namespace {
/// m^2, of the corner at a in the triangle a, b, c.
double share_of_corner(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c) {
  const Vector<3> ab = b - a, ac = c - a, bc = c - b;
  const double twice_area = ab.cross(ac).norm();
  if (ab.dot(ac) < 0.) return 0.25 * twice_area;
  if (ab.dot(bc) > 0. || ac.dot(bc) < 0.) return 0.125 * twice_area;  // obtuse at b or at c
  const double cot_b = -ab.dot(bc) / twice_area, cot_c = ac.dot(bc) / twice_area;
  return 0.125 * (ac.squaredNorm() * cot_b + ab.squaredNorm() * cot_c);
}
}  // namespace

std::vector<double> facet_curvature(const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes,
                                    const double crease) {
  std::vector<double> bent(nodes.size(), 0.), area(nodes.size(), 0.);
  std::vector<Vector<3>> normal;
  for (const auto &f : mesh.faces) {
    const Vector<3> &a = nodes[f[0]], &b = nodes[f[1]], &c = nodes[f[2]];
    normal.push_back((b - a).cross(c - a).normalized());
    area[f[0]] += share_of_corner(a, b, c);
    area[f[1]] += share_of_corner(b, c, a);
    area[f[2]] += share_of_corner(c, a, b);
  }
  std::vector<unsigned char> sharp(nodes.size(), 0);
  for (const TriangleMesh::Edge &edge : mesh.edges) {
    const Vector<3> along = nodes[edge.b] - nodes[edge.a];
    const double l = along.norm();
    const Vector<3> turn = normal[edge.left].cross(normal[edge.right]);
    const double theta = std::atan2(turn.dot(along) / l, normal[edge.left].dot(normal[edge.right]));
    if (std::abs(theta) > crease) sharp[edge.a] = sharp[edge.b] = 1;
    if (std::abs(theta) < 1e-6) continue;
    for (const auto node : {edge.a, edge.b}) bent[node] += 0.25 * l * theta;
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) bent[k] = sharp[k] ? 0. : bent[k] / area[k];
  return bent;
}
}  // namespace turgor
