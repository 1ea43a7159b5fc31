#include "micro/cells/depth_below_surface.h"

#include "micro/geometry/bins.h"

#include <algorithm>

namespace turgor {
std::vector<unsigned char> deeper_than(const double rim, const Particles<3> &particles,
                                       const OuterCells &outer) {
  const double L = 4. * outer.mean_radius;
  std::vector<double> side[3],
      height;  // of the outermost cells: their direction, at the mean edge; their distance from the centroid
  for (std::size_t k = 0; k < outer.cells.size(); ++k)
    if (outer.exposure[k] >= 0.5) {
      const Vector<3> from = particles.position(outer.cells[k]) - outer.centre;
      height.push_back(from.norm());
      for (int d = 0; d < 3; ++d)
        side[d].push_back(height.back() > 0. ? outer.edge / height.back() * from[d] : 0.);
    }
  const double *places[3] = {side[0].data(), side[1].data(), side[2].data()};
  const double low[3] = {-outer.edge, -outer.edge, -outer.edge},
               high[3] = {outer.edge, outer.edge, outer.edge};
  const Bins<3> bins(places, std::uint32_t(height.size()), 0.5 * L, low, high);
  std::vector<unsigned char> deep(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vector<3> from = particles.position(i) - outer.centre;
    const double r = from.norm();
    const Vector<3> to =
        r > 0. ? Vector<3>(outer.edge / r * from) : Vector<3>(outer.edge * Vector<3>::UnitZ());
    double weights = 0., sum = 0.;
    bins.near_runs(to.data(), L, [&](const std::uint32_t first, const std::uint32_t last) {
      for (std::uint32_t n = first; n < last; ++n) {
        const std::uint32_t j = bins.sorted()[n];
        const double a = side[0][j] - to[0], b = side[1][j] - to[1], c = side[2][j] - to[2];
        const double weight = std::max(0., 1. - (a * a + b * b + c * c) / (L * L));
        weights += weight;
        sum += weight * height[j];
      }
    });
    const double edge =
        weights > 0. ? sum / weights + outer.mean_radius : outer.edge;  // a gap as wide as 2 L
    deep[i] = edge - r > rim;
  }
  return deep;
}
}  // namespace turgor
