// The triangles within reach of each fluid particle, with the quadrature that each needs.
#include "micro/engine/bins.h"
#include "micro/terms/sph_lists.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace turgor
{
namespace
{
/// Distance from the centroid over the largest distance of a corner from it, from which quadratures 1, 2, 3 do. Measured on spheres with 600 to 10 000
/// particles and 640 to 4000 faces: a face then gives gamma to 1e-6 (6 points on D) and 3e-6 (3 points); all faces of a particle together to 6e-6, as against 6 points and the angle for all.
constexpr double far_enough[sph::quadratures] = {0., 3., 4., 12.};

double distance_to_triangle(const Vector<3> &p, const Vector<3> &a, const Vector<3> &b, const Vector<3> &c)
{
  const Vector<3> ab = b - a, ac = c - a, n = ab.cross(ac);
  const Vector<3> corners[3] = {a, b, c};
  double least = HUGE_VAL;
  bool above = true; // the foot of the perpendicular lies in the triangle
  for (int k = 0; k < 3; ++k)
    {
      const Vector<3> &from = corners[k], edge = corners[(k + 1) % 3] - from, to = p - from;
      above = above && n.cross(edge).dot(to) >= 0.;
      const double along = std::clamp(to.dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0., 1.);
      least = std::min(least, (to - along * edge).norm());
    }
  return above && n.norm() > 0. ? std::abs(n.normalized().dot(p - a)) : least;
}
} // namespace

void WallFans::clear(const std::uint32_t particles)
{
  fans.assign(particles, sph::Fan());
  nodes.clear();
  corners.clear();
  largest = 0;
}

void WallFans::build(const ListOrigin<3> &origin, const std::uint32_t nw, const TriangleMesh &mesh, const double reach,
                     const double slack, const double near, const std::vector<unsigned char> *gone)
{
  const std::uint32_t n = std::uint32_t(origin.size()) - nw;
  clear(n);
  const auto position = [&](const std::uint32_t i) { return Vector<3>(origin[0][i], origin[1][i], origin[2][i]); };

  // Faces that are left: centroid and size.
  std::vector<double> middle[3], size;
  std::vector<std::uint32_t> face;
  double largest_size = 0.;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
      if (gone != nullptr && (*gone)[f] != 0)
        continue;
      const auto &corner = mesh.faces[f];
      const Vector<3> m = (position(corner[0]) + position(corner[1]) + position(corner[2])) / 3.;
      double r = 0.;
      for (const std::uint16_t k : corner)
        r = std::max(r, (position(k) - m).norm());
      for (int d = 0; d < 3; ++d)
        middle[d].push_back(m[d]);
      size.push_back(r);
      face.push_back(f);
      largest_size = std::max(largest_size, r);
    }
  if (face.empty())
    return;
  const double *x[3];
  double lo[3], hi[3];
  for (int d = 0; d < 3; ++d)
    {
      x[d] = middle[d].data();
      lo[d] = *std::min_element(middle[d].begin(), middle[d].end());
      hi[d] = *std::max_element(middle[d].begin(), middle[d].end());
    }
  const double range = reach + largest_size;
  const Bins<3> bins(x, std::uint32_t(face.size()), range / 2., lo, hi);

  std::vector<std::pair<double, std::uint32_t>> found[sph::quadratures]; // nearest first: chunks out of the support are skipped
  std::vector<std::uint32_t> seen_by(nw, n);
  std::vector<std::uint16_t> number(nw);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      for (auto &list : found)
        list.clear();
      const Vector<3> p = position(nw + i);
      bins.near(p.data(), [&](const std::uint32_t k) {
        const double dx = x[0][k] - p[0], dy = x[1][k] - p[1], dz = x[2][k] - p[2], d2 = dx * dx + dy * dy + dz * dz;
        if (d2 > (reach + size[k]) * (reach + size[k]))
          return;
        const auto &corner = mesh.faces[face[k]];
        if (d2 > reach * reach
            && distance_to_triangle(p, position(corner[0]), position(corner[1]), position(corner[2])) > reach)
          return;
        const double distance = std::sqrt(d2) - slack;
        int q = sph::quadratures - 1;
        while (q > 0 && (distance < far_enough[q] * size[k] || distance < near + size[k]))
          --q;
        found[q].push_back({d2, face[k]});
      });
      sph::Fan &fan = fans[i];
      fan.first_node = std::uint32_t(nodes.size());
      fan.first_corner = std::uint32_t(corners.size());
      for (int q = 0; q < sph::quadratures; ++q)
        {
          std::sort(found[q].begin(), found[q].end());
          fan.faces[q] = std::uint16_t(found[q].size());
          for (std::size_t chunk = 0; chunk < found[q].size(); chunk += sph::list_padding)
            for (int c = 0; c < 3; ++c)
              for (std::size_t k = chunk; k < chunk + sph::list_padding; ++k)
                {
                  if (k >= found[q].size())
                    {
                      corners.push_back(0); // three times the same node: no area
                      continue;
                    }
                  const std::uint16_t node = mesh.faces[found[q][k].second][c];
                  if (seen_by[node] != i)
                    {
                      seen_by[node] = i;
                      number[node] = fan.nodes++;
                      nodes.push_back(node);
                    }
                  corners.push_back(number[node]);
                }
          if (q == 0)
            fan.near_nodes = fan.nodes;
        }
      largest = std::max<std::uint32_t>(largest, fan.nodes);
    }
}
} // namespace turgor
