#include "micro/terms/facet_neighbours.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
void FacetNeighbours::extend(const CellSurfaces &surfaces) {
  const std::size_t before = across.size(), all = surfaces.triangles.size();
  if (before == all) return;
  across.resize(all);
  cell.resize(all);
  for (; known < surfaces.size(); ++known) {
    const auto [begin, end] = surfaces.triangles_of(known);
    std::fill(cell.begin() + begin, cell.begin() + end, known);
  }
  const std::size_t first_node = first_of_node.size() - 1;
  std::size_t nodes = first_node;
  for (std::size_t f = before; f < all; ++f)
    for (const std::uint32_t i : surfaces.triangles[f]) nodes = std::max(nodes, i + std::size_t(1));
  first_of_node.resize(nodes + 1, 0);
  for (std::size_t f = before; f < all; ++f)
    for (const std::uint32_t i : surfaces.triangles[f]) ++first_of_node[i + 1];
  for (std::size_t i = first_node; i < nodes; ++i) first_of_node[i + 1] += first_of_node[i];
  of_node.resize(first_of_node[nodes]);
  std::vector<std::uint32_t> next(first_of_node.begin() + std::ptrdiff_t(first_node),
                                  first_of_node.end() - 1);
  for (std::size_t f = before; f < all; ++f)
    for (const std::uint32_t i : surfaces.triangles[f]) of_node[next[i - first_node]++] = std::uint32_t(f);
  const auto beyond = [&](const std::uint32_t a, const std::uint32_t b) {  // the facet with the edge b -> a
    for (std::uint32_t k = first_of_node[a]; k < first_of_node[a + 1]; ++k) {
      const CellSurfaces::Triangle &corner = surfaces.triangles[of_node[k]];
      for (std::size_t m = 0; m < 3; ++m)
        if (corner[m] == b && corner[(m + 1) % 3] == a) return of_node[k];
    }
    throw std::logic_error("a surface of a cell is not closed");
  };
  for (std::size_t f = before; f < all; ++f)
    for (std::size_t k = 0; k < 3; ++k)
      across[f][k] = beyond(surfaces.triangles[f][k], surfaces.triangles[f][(k + 1) % 3]);
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
