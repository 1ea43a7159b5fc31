// The cells of a cluster that are seen from outside, how much of each, and the cluster's edge (thesis 5.4.2).
//
//   exposure of a cell   share of the lines towards the centroid that meet it which meet no other cell
//                        before: 1 on top, 0 inside
//   edge                 mean distance from the centroid of the cells at least half exposed, the "most outer"
//                        ones, plus one mean radius
//
// Lines: one in each patch of a grid of directions, rings of equal width in the polar angle, each cut into
// equal parts nearest to squares, about 25 to a cell at the farthest. Cells are taken from the farthest
// inwards until 99 % of the lines have met one, and two mean diameters beyond: what lies deeper is not seen.
// Ties go to the cell farther out, then to the first. In: positions, radii (m). Out: indices (rising),
// exposures (no unit), edge (m).
#pragma once

#include "micro/engine/particles.h"

#include <cstdint>
#include <vector>

namespace turgor {
struct OuterCells {
  Vector<3> centre = Vector<3>::Zero();  ///< centroid of all cells, m
  std::vector<std::uint32_t> cells;      ///< of exposure > 0
  std::vector<double> exposure;          ///< of cells
  double edge = 0.;                      ///< m, from the centre
  double mean_radius = 0.;               ///< m
};

/// Throws std::runtime_error where positions or radii are not finite.
OuterCells find_outer_cells(const Particles<3> &particles);
}  // namespace turgor
