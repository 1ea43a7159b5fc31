// Which facets of deformable cells meet at their edges and nodes, and the pseudo-normals there, by whose side
// a place is inside or outside (J. A. Baerentzen and H. Aanaes 2005): of a facet its normal; of an edge the
// sum of both facets'; of a node the sum of its facets', each times its angle there.
//
//   FacetNeighbours neighbours(surfaces);
//   neighbours.pseudo_normal(facet, closest, surfaces, points)        of any length
#pragma once

#include "micro/geometry/closest_point.h"
#include "micro/terms/surface_points.h"

namespace turgor {
class FacetNeighbours {
 public:
  explicit FacetNeighbours(const CellSurfaces &surfaces) { extend(surfaces); }
  /// Cells that have come behind those it knows.
  void extend(const CellSurfaces &surfaces);

  /// Of the feature of a facet on which a closest point lies; points: where it lies now.
  Vector<3> pseudo_normal(std::uint32_t facet, const ClosestPoint &closest, const CellSurfaces &surfaces,
                          const SurfacePoints &points) const;

  std::size_t facets() const { return across.size(); }
  std::size_t cells() const { return known; }
  std::uint32_t cell_of(const std::uint32_t facet) const { return cell[facet]; }

 private:
  std::vector<std::array<std::uint32_t, 3>>
      across;  ///< of edge k, from corner k to the next: the other facet
  std::vector<std::uint32_t> cell, first_of_node{0}, of_node;
  std::uint32_t known = 0;  ///< cells
};
}  // namespace turgor
