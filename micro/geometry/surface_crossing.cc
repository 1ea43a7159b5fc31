#include "micro/geometry/surface_crossing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>

namespace turgor {
namespace {
using Face = std::array<std::uint16_t, 3>;

double six_volumes(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c, const Vector<3> &d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// The segment from p to q through the inside of a, b, c.
bool passes(const Vector<3> &p, const Vector<3> &q, const Vector<3> &a, const Vector<3> &b,
            const Vector<3> &c) {
  const double above = six_volumes(a, b, c, p), below = six_volumes(a, b, c, q);
  if (!(above * below < 0.)) return false;
  const double u = six_volumes(p, q, a, b), v = six_volumes(p, q, b, c), w = six_volumes(p, q, c, a);
  return (u > 0. && v > 0. && w > 0.) || (u < 0. && v < 0. && w < 0.);
}

bool has(const Face &face, const std::uint16_t node) {
  return face[0] == node || face[1] == node || face[2] == node;
}

/// An edge of `one` that does not touch `other` through it.
bool pierces(const Face &one, const Face &other, const std::vector<Vector<3>> &x) {
  for (int k = 0; k < 3; ++k)
    if (const auto a = one[k], b = one[(k + 1) % 3]; !has(other, a) && !has(other, b))
      if (passes(x[a], x[b], x[other[0]], x[other[1]], x[other[2]])) return true;
  return false;
}

struct Extent {
  Vector<3> low, high;
};
}  // namespace

std::optional<std::pair<std::uint32_t, std::uint32_t>> find_crossing(const TriangleMesh &mesh,
                                                                     const std::vector<Vector<3>> &nodes) {
  for (const TriangleMesh::Edge &edge : mesh.edges) {
    const Vector<3> along = (nodes[edge.b] - nodes[edge.a]).normalized();
    const auto across = [&](const std::uint16_t node) {
      const Vector<3> r = nodes[node] - nodes[edge.a];
      return Vector<3>((r - r.dot(along) * along).normalized());
    };
    if ((across(edge.c) - across(edge.d)).norm() < 1e-6) return std::pair(edge.left, edge.right);
  }
  std::vector<Extent> box;
  for (const Face &f : mesh.faces)
    box.push_back({nodes[f[0]].cwiseMin(nodes[f[1]]).cwiseMin(nodes[f[2]]),
                   nodes[f[0]].cwiseMax(nodes[f[1]]).cwiseMax(nodes[f[2]])});
  std::vector<std::uint32_t> order(box.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](const auto a, const auto b) { return box[a].low[0] < box[b].low[0]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Extent &one = box[order[i]];
    for (std::size_t k = i + 1; k < order.size() && box[order[k]].low[0] <= one.high[0]; ++k) {
      const Extent &two = box[order[k]];
      if (two.low[1] > one.high[1] || one.low[1] > two.high[1] || two.low[2] > one.high[2] ||
          one.low[2] > two.high[2])
        continue;
      const Face &f = mesh.faces[order[i]], &g = mesh.faces[order[k]];
      if (pierces(f, g, nodes) || pierces(g, f, nodes)) return std::minmax(order[i], order[k]);
    }
  }
  return std::nullopt;
}
}  // namespace turgor
