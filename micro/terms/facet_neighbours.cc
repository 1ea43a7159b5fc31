#include "micro/terms/facet_neighbours.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace turgor {
FacetNeighbours::FacetNeighbours(const CellSurfaces &surfaces)
    : across(surfaces.triangles.size()), cell(surfaces.triangles.size()) {
  std::uint32_t nodes = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> running;  // a -> b: its facet
  for (std::uint32_t c = 0; c < surfaces.size(); ++c) {
    const auto [begin, end] = surfaces.triangles_of(c);
    running.clear();
    for (std::uint32_t f = begin; f < end; ++f) {
      cell[f] = c;
      for (std::size_t k = 0; k < 3; ++k) {
        running[{surfaces.triangles[f][k], surfaces.triangles[f][(k + 1) % 3]}] = f;
        nodes = std::max(nodes, surfaces.triangles[f][k] + 1);
      }
    }
    for (std::uint32_t f = begin; f < end; ++f)
      for (std::size_t k = 0; k < 3; ++k)
        across[f][k] = running.at({surfaces.triangles[f][(k + 1) % 3], surfaces.triangles[f][k]});
  }
  first_of_node.assign(nodes + std::size_t(1), 0);
  for (const auto &corners : surfaces.triangles)
    for (const std::uint32_t i : corners) ++first_of_node[i + 1];
  for (std::size_t i = 0; i < nodes; ++i) first_of_node[i + 1] += first_of_node[i];
  of_node.resize(first_of_node[nodes]);
  std::vector<std::uint32_t> next(first_of_node.begin(), first_of_node.end() - 1);
  for (std::uint32_t f = 0; f < surfaces.triangles.size(); ++f)
    for (const std::uint32_t i : surfaces.triangles[f]) of_node[next[i]++] = f;
}

Vector<3> FacetNeighbours::pseudo_normal(const std::uint32_t facet, const ClosestPoint &closest,
                                         const CellSurfaces &surfaces, const SurfacePoints &points) const {
  if (closest.on == ClosestPoint::inside) return points.normal[facet];
  if (closest.on == ClosestPoint::edge)
    return points.normal[facet] + points.normal[across[facet][std::size_t(closest.which)]];
  const std::uint32_t node = surfaces.triangles[facet][std::size_t(closest.which)];
  const Vector<3> &here = points.of_node(cell[facet], node);
  Vector<3> sum = Vector<3>::Zero();
  for (std::uint32_t k = first_of_node[node]; k < first_of_node[node + 1]; ++k) {
    const CellSurfaces::Triangle &corners = surfaces.triangles[of_node[k]];
    const std::size_t m = corners[0] == node ? 0 : corners[1] == node ? 1 : 2;
    const Vector<3> u = points.of_node(cell[facet], corners[(m + 1) % 3]) - here,
                    v = points.of_node(cell[facet], corners[(m + 2) % 3]) - here;
    sum += std::acos(std::clamp(u.dot(v) / std::sqrt(u.squaredNorm() * v.squaredNorm()), -1., 1.)) *
           points.normal[of_node[k]];
  }
  return sum;
}
}  // namespace turgor
