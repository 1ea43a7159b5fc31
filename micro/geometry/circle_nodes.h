// Nodes of a circle about the origin: a polygon of the same area, for walls and rigid cells in the plane.
#pragma once

#include "micro/geometry/tensor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace turgor {
/// m; about `spacing` apart, at least 24. What is on their left: the inside, clockwise the outside.
inline std::vector<Vector<2>> circle_nodes(const double radius, const double spacing, const bool clockwise) {
  const unsigned int n = std::max(24u, unsigned(std::lround(2. * std::numbers::pi * radius / spacing)));
  const double step = 2. * std::numbers::pi / n, r = radius * std::sqrt(step / std::sin(step));
  std::vector<Vector<2>> nodes;
  for (unsigned int k = 0; k < n; ++k) {
    const double a = (clockwise ? -1. : 1.) * step * k;
    nodes.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return nodes;
}
}  // namespace turgor
