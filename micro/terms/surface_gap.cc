// How near cells are to each other between the points at which their contact is asked.
#include "micro/terms/surface_contacts.h"

#include <algorithm>
#include <cmath>

namespace turgor {
double SurfaceContacts::gap_at(const Vector<3> &x, std::span<const std::uint32_t> facets) const {
  std::vector<Near> found;
  double lowest = HUGE_VAL;
  while (!facets.empty()) {
    const auto of_cell = first_cell_of(facets);
    facets = facets.subspan(of_cell.size());
    const double sign = near_of(x, of_cell, found);
    double least = HUGE_VAL;
    for (const Near &one : found) least = std::min(least, one.square);
    if (!found.empty()) lowest = std::min(lowest, sign * std::sqrt(least));
  }
  return lowest;
}

double SurfaceContacts::lowest_gap() const {
  double lowest = HUGE_VAL;
  std::vector<std::uint32_t> facets;
  for (std::size_t cell = 0; cell < surfaces->size(); ++cell) {
    const auto [begin, end] = surfaces->triangles_of(cell);
    const std::uint32_t centroids = points.of_cell(cell)[1] - (end - begin);
    for (std::uint32_t f = begin; f < end; ++f) {
      const CellSurfaces::Triangle &corner = surfaces->triangles[f];
      facets.clear();
      const auto take = [&](const std::uint32_t point) {
        const auto near = lists.of(point);
        facets.insert(facets.end(), near.begin(), near.end());
      };
      take(centroids + f - begin);
      for (const std::uint32_t node : corner) take(points.point_of(cell, node));
      if (facets.empty()) continue;
      std::sort(facets.begin(), facets.end());
      facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
      const Vector<3> &a = points.of_node(cell, corner[0]), u = points.of_node(cell, corner[1]) - a,
                      v = points.of_node(cell, corner[2]) - a;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; i + j < 4; ++j)
          for (int other = 0; other < (i + j < 3 ? 2 : 1); ++other) {
            const double in = (1. + other) / 3.;  // of the small triangle that points the other way
            lowest = std::min(lowest, gap_at(a + 0.25 * ((i + in) * u + (j + in) * v), facets));
          }
    }
  }
  return lowest;
}
}  // namespace turgor
