#include "micro/geometry/triangle_mesh.h"

#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace turgor {
void TriangleMesh::complete() {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::pair<std::uint32_t, std::uint16_t>>
      half;  // a, b -> face, third node
  nodes = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const std::uint16_t a = faces[f][k], b = faces[f][(k + 1) % 3], c = faces[f][(k + 2) % 3];
      nodes = std::max(nodes, std::uint32_t(a) + 1);
      if (!half.insert({{a, b}, {f, c}}).second)
        throw std::invalid_argument(
            "the triangles do not form an oriented surface: two go along the edge from node " +
            number_text(a) + " to node " + number_text(b) +
            " (counted from 0) the same way: one of them is turned over or there twice. "
            "All have to be counter-clockwise seen from outside.");
    }
  edges.clear();
  edges_of_face.assign(faces.size(), {});
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const std::uint16_t a = faces[f][k], b = faces[f][(k + 1) % 3];
      const auto other = half.find({b, a});
      if (other == half.end())
        throw std::invalid_argument("the triangles are not closed at the edge from node " + number_text(a) +
                                    " to node " + number_text(b) +
                                    " (counted from 0), which has one triangle: a closed surface has two at "
                                    "every edge. Close the hole, or join nodes that lie on each other.");
      const std::uint32_t g = other->second.first;
      if (g < f) continue;  // named by the face before
      const std::uint32_t e = std::uint32_t(edges.size());
      edges.push_back({a, b, faces[f][(k + 2) % 3], other->second.second, f, g});
      edges_of_face[f][k] = e;
      for (int m = 0; m < 3; ++m)
        if (faces[g][m] == b && faces[g][(m + 1) % 3] == a) edges_of_face[g][m] = e;
    }
}

double TriangleMesh::volume(const double *x, const double *y, const double *z) const {
  double six = 0.;
  for (const auto &face : faces) {
    const int a = face[0], b = face[1], c = face[2];
    six += x[a] * (y[b] * z[c] - z[b] * y[c]) + y[a] * (z[b] * x[c] - x[b] * z[c]) +
           z[a] * (x[b] * y[c] - y[b] * x[c]);
  }
  return six / 6.;
}

double TriangleMesh::area(const double *x, const double *y, const double *z) const {
  double twice = 0.;
  for (const auto &face : faces) {
    const Vector<3> a(x[face[0]], y[face[0]], z[face[0]]), b(x[face[1]], y[face[1]], z[face[1]]),
        c(x[face[2]], y[face[2]], z[face[2]]);
    twice += (b - a).cross(c - a).norm();
  }
  return 0.5 * twice;
}
}  // namespace turgor
