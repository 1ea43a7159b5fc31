// Nodes and area of a wall ring in interleaved positions x (m: x_0 y_0 x_1 y_1 ...).
#pragma once

#include "micro/cells/cell_layout.h"

#include <cstdint>
#include <vector>

namespace turgor {
inline Vector<2> at(const std::vector<double> &x, const std::size_t node) {
  return {x[2 * node], x[2 * node + 1]};
}

/// m^2, relative to the first node, so that its round-off does not grow with the distance from the origin.
inline double polygon_area(const std::vector<double> &x, const WallRing &ring) {
  const double x0 = x[2 * ring.first], y0 = x[2 * ring.first + 1];
  double twice = 0.;
  for (std::uint32_t k = 1; k + 1 < ring.count; ++k) {
    const double *a = &x[2 * (ring.first + k)];
    twice += (a[0] - x0) * (a[3] - y0) - (a[2] - x0) * (a[1] - y0);
  }
  return 0.5 * twice;
}
}  // namespace turgor
