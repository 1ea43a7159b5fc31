// Which facets of other cells each point of a cell's surface may touch: found through square cells of space
// over the facets' centroids, from `reach` and a skin away, and good until a node has moved by half the skin.
//
//   FacetLists lists(reach, skin);                           m
//   lists.bring_up_to_date(surfaces, neighbours, particles, points, threads);
//   for (std::uint32_t facet : lists.of(point)) ...          in their order, whenever the list was built:
//   what
//     is made of those within reach does not depend on when that was
#pragma once

#include "micro/terms/facet_neighbours.h"

#include <limits>

namespace turgor {
class FacetLists {
 public:
  FacetLists(const double reach_, const double skin_) : reach(reach_), skin(skin_) {}

  void bring_up_to_date(const CellSurfaces &surfaces, const FacetNeighbours &neighbours,
                        const Particles<3> &particles, const SurfacePoints &points, unsigned int threads);
  void forget() { first.clear(); }
  std::size_t held =
      std::numeric_limits<std::size_t>::max();  ///< cells from there on do not touch each other

  std::span<const std::uint32_t> of(const std::uint32_t point) const {
    return {facet.data() + first[point], first[point + 1] - first[point]};
  }
  std::uint64_t builds() const { return built; }
  std::size_t entries() const { return facet.size(); }

 private:
  bool covers(const Particles<3> &particles) const;

  double reach, skin;
  std::uint64_t built = 0;
  Particles<3>::Components at;  ///< m, where the nodes were
  std::vector<std::uint32_t> first, facet;
};
}  // namespace turgor
