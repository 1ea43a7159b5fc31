// The outermost cells of a cluster, and its edge (thesis 5.4.2): seen from the centroid, directions are shared out into patches of
// about one cell's area at the edge; the cell farthest out in each is an outer cell, unless it lies more than one mean diameter
// below the mean of these. The edge is the mean distance of the outer cells plus one mean radius.
//
// Patches: rings of equal width in the polar angle, each cut into equal parts nearest to squares. Ties go to the first cell.
// In: positions, radii (m). Out: indices (rising), distances and edge (m).
#pragma once

#include "micro/engine/particles.h"

#include <cstdint>
#include <vector>

namespace turgor
{
struct OuterCells
{
  Vector<3> centre = Vector<3>::Zero(); ///< centroid of all cells, m
  std::vector<std::uint32_t> cells;
  double edge = 0.;       ///< m, from the centre
  double mean_radius = 0.; ///< m
};

/// Throws std::runtime_error where positions or radii are not finite.
OuterCells find_outer_cells(const Particles<3> &particles);
} // namespace turgor
