// The pairs of one cell in the thesis's fluid (thesis_fluid.h): fluid with fluid, each once, and fluid with
// the nodes of the wall, found in bins as wide as the longer reach. And who is outside: a ray in x from a
// particle inside crosses the wall an odd number of times.
//
//   ThesisPairs<2> pairs;
//   if (pairs.built_at.stale(particles, group, skin)) { pairs.built_at.take(particles.x, group);
//     pairs.build(group, reach, wall_reach, {}); }
#pragma once

#include "micro/terms/list_origin.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor {
/// Indices within the group; those of the fluid count from its first.
template <int dim>
struct ThesisPairs {
  using Faces = std::vector<std::array<std::uint16_t, 3>>;

  std::vector<std::uint32_t> fluid,
      wall;  ///< partners of fluid i, j > i, and nodes: from first_...[i] to first_...[i + 1]
  std::vector<std::uint32_t> first_fluid, first_wall;
  ListOrigin<dim> built_at;
  std::size_t crossed = 0, builds = 0;  ///< fluid outside the wall when the list was built; how often it was

  /// From built_at. Reaches: m, skin included. faces: of the wall in 3D; none: nobody is counted as outside.
  void build(const Group &group, double reach, double wall_reach, const Faces &faces);

  /// visit(i, j, r, r.r) for each pair of fluid closer than `support` (m) once; r = x_j - x_i, x from the
  /// first fluid particle on.
  template <class Visit>
  void for_fluid(const std::array<const double *, dim> &x, const double support, Visit &&visit) const {
    for (std::uint32_t i = 0; i + 1 < first_fluid.size(); ++i)
      for (std::uint32_t k = first_fluid[i]; k < first_fluid[i + 1]; ++k) {
        const std::uint32_t j = fluid[k];
        std::array<double, dim> r;
        double r2 = 0.;
        for (int d = 0; d < dim; ++d) {
          r[d] = x[d][j] - x[d][i];
          r2 += r[d] * r[d];
        }
        if (r2 < support * support) visit(i, j, r, r2);
      }
  }

  std::size_t memory_bytes() const;

 private:
  std::size_t count_outside(const Group &group, const Faces &faces) const;
};

extern template struct ThesisPairs<2>;
extern template struct ThesisPairs<3>;
}  // namespace turgor
