#include "micro/geometry/surface_nesting.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

namespace turgor {
namespace {
struct Part {
  std::vector<std::uint32_t> faces;
  Vector<3> low, high;
  double volume = 0.;  ///< m^3, negative: faces inwards
};

/// Parts in the order of their first triangles: what hangs together over edges.
std::vector<Part> parts_of(const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes) {
  std::vector<Part> parts;
  std::vector<char> known(mesh.faces.size(), 0);
  for (std::uint32_t first = 0; first < mesh.faces.size(); ++first) {
    if (known[first]) continue;
    known[first] = 1;
    Part part{{first}, nodes[mesh.faces[first][0]], nodes[mesh.faces[first][0]]};
    const Vector<3> origin = part.low;
    for (std::size_t k = 0; k < part.faces.size(); ++k) {
      const auto &face = mesh.faces[part.faces[k]];
      for (const auto node : face) {
        part.low = part.low.cwiseMin(nodes[node]);
        part.high = part.high.cwiseMax(nodes[node]);
      }
      part.volume +=
          (nodes[face[0]] - origin).dot((nodes[face[1]] - origin).cross(nodes[face[2]] - origin)) / 6.;
      for (const std::uint32_t e : mesh.edges_of_face[part.faces[k]])
        for (const std::uint32_t next : {mesh.edges[e].left, mesh.edges[e].right})
          if (!known[next]) {
            known[next] = 1;
            part.faces.push_back(next);
          }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Of a part around x, in turns: 1 inside of one that faces outwards.
double turns(const Part &part, const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes,
             const Vector<3> &x) {
  double angle = 0.;
  for (const std::uint32_t f : part.faces) {
    const Vector<3> a = nodes[mesh.faces[f][0]] - x, b = nodes[mesh.faces[f][1]] - x,
                    c = nodes[mesh.faces[f][2]] - x;
    const double A = a.norm(), B = b.norm(), C = c.norm();
    angle += 2. * std::atan2(a.dot(b.cross(c)), A * B * C + a.dot(b) * C + a.dot(c) * B + b.dot(c) * A);
  }
  return angle / (4. * std::numbers::pi);
}
}  // namespace

std::optional<WrongNesting> find_wrong_nesting(const TriangleMesh &mesh,
                                               const std::vector<Vector<3>> &nodes) {
  const std::vector<Part> parts = parts_of(mesh, nodes);
  for (const Part &part : parts) {
    const Vector<3> &x = nodes[mesh.faces[part.faces[0]][0]];
    double around = 0.;
    for (const Part &other : parts)
      if (&other != &part && (x.array() >= other.low.array()).all() &&
          (x.array() <= other.high.array()).all())
        around += turns(other, mesh, nodes, x);
    const bool outwards = part.volume > 0.;
    if (std::abs(around - (outwards ? 0. : 1.)) > 0.5)
      return WrongNesting{parts.size(), part.faces[0], outwards};
  }
  return std::nullopt;
}
}  // namespace turgor
