// Around the near faces of each fluid particle: the rims that alone decide the angle under which these faces
// are seen.
#include "micro/terms/sph_lists.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace turgor {
namespace {
double distance_to_triangle(const Vector<3> &p, const Vector<3> &a, const Vector<3> &b, const Vector<3> &c) {
  const Vector<3> ab = b - a, ac = c - a, n = ab.cross(ac);
  const Vector<3> corners[3] = {a, b, c};
  double least = HUGE_VAL;
  bool above = true;  // the foot of the perpendicular lies in the triangle
  for (int k = 0; k < 3; ++k) {
    const Vector<3> &from = corners[k], edge = corners[(k + 1) % 3] - from, to = p - from;
    above = above && n.cross(edge).dot(to) >= 0.;
    const double along = std::clamp(to.dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0., 1.);
    least = std::min(least, (to - along * edge).norm());
  }
  return above && n.norm() > 0. ? std::abs(n.normalized().dot(p - a)) : least;
}
}  // namespace

// Sides into closed ways: each begins where one ends.
void WallFaces::close_rims(const std::uint32_t i, std::vector<Side> &sides) {
  while (!sides.empty()) {
    sph::Rim rim;
    rim.particle = i;
    rim.first = std::uint32_t(rim_nodes.size());
    const std::uint16_t start = sides.back().from;
    std::uint16_t at = sides.back().to;
    rim_nodes.push_back(start);
    sides.pop_back();
    while (at != start) {
      rim_nodes.push_back(at);
      const auto side = std::find_if(sides.begin(), sides.end(), [&](const Side &s) { return s.from == at; });
      at = side->to;
      *side = sides.back();
      sides.pop_back();
    }
    rim.count = std::uint32_t(rim_nodes.size()) - rim.first;
    longest = std::max(longest, rim.count);
    rim_nodes.resize((rim_nodes.size() + sph::list_padding - 1) / sph::list_padding * sph::list_padding,
                     start);
    rims.push_back(rim);
  }
}

// Those of each particle, as the faces' lists have it: from first[i] to first[i + 1].
std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>> WallFaces::near_faces(
    const std::uint32_t n) const {
  std::vector<std::uint32_t> first(n + 1, 0), near;
  for (const sph::FaceList &list : faces)
    for (std::uint32_t k = 0; k < list.count[0]; ++k) ++first[particles[list.first + k] + 1];
  for (std::uint32_t i = 0; i < n; ++i) first[i + 1] += first[i];
  near.resize(first[n]);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (const sph::FaceList &list : faces)
    for (std::uint32_t k = 0; k < list.count[0]; ++k) near[next[particles[list.first + k]]++] = list.face;
  return {first, near};
}

void WallFaces::build_rims(const ListOrigin<3> &origin, const std::uint32_t nw, const TriangleMesh &mesh,
                           const std::vector<Vector<3>> &middle, const std::vector<double> &size,
                           const double slack) {
  const std::uint32_t n = std::uint32_t(origin.size()) - nw;
  const auto position = [&](const std::uint32_t i) {
    return Vector<3>(origin[0][i], origin[1][i], origin[2][i]);
  };
  const auto [first, near] = near_faces(n);
  std::vector<Side> sides;
  std::vector<std::array<std::uint32_t, 3>> across(
      mesh.faces.size());  // the face beyond the side that begins at corner k
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const TriangleMesh::Edge &edge = mesh.edges[mesh.edges_of_face[f][k]];
      across[f][k] = edge.left == f ? edge.right : edge.left;
    }
  std::vector<std::uint32_t> seen_by(mesh.faces.size(), n);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (first[i] == first[i + 1]) continue;
    const Vector<3> x = position(nw + i);
    // Towards the nearest centroid.
    double least = HUGE_VAL;
    std::uint32_t nearest = 0;
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
      const double d2 = (middle[near[k]] - x).squaredNorm();
      if (d2 < least) {
        least = d2;
        nearest = near[k];
      }
      seen_by[near[k]] = i;
    }
    const Vector<3> direction =
        least > 0. ? Vector<3>((middle[nearest] - x) / std::sqrt(least)) : Vector<3>(0., 0., 1.);
    for (int d = 0; d < 3; ++d) toward[3 * std::size_t(i) + d] = direction[d];

    sides.clear();
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
      const std::uint32_t f = near[k];
      const auto &corner = mesh.faces[f];
      for (int c = 0; c < 3; ++c)
        if (seen_by[across[f][c]] != i) sides.push_back({corner[c], corner[(c + 1) % 3]});
      // Can the ray from the particle away from `toward` come to meet the face before the next build?
      const Vector<3> m = middle[f] - x;
      const double along = std::min(0., m.dot(direction)), most = slack + size[f];
      if ((m - along * direction).squaredNorm() > most * most) continue;
      const Vector<3> r[3] = {position(corner[0]) - x, position(corner[1]) - x, position(corner[2]) - x};
      if (std::min({direction.dot(r[0]), direction.dot(r[1]), direction.dot(r[2])}) < 0. ||
          distance_to_triangle(Vector<3>::Zero(), r[0], r[1], r[2]) <= slack)
        doubts.push_back({i, f});
    }
    close_rims(i, sides);
  }
}
}  // namespace turgor
