// Periodic Laguerre (power) tessellation in which every cell has the area it is asked to have; with equal
// areas nearly the Voronoi tessellation. voro++ computes the cells, of a layer one cell thick; here are the
// seeds and weights.
//
//   cell i = the points x for which |x - x_i|^2 - w_i is least
//   rounds: every seed goes to the centroid of its cell (Lloyd); each is a step towards order. Then the
//           weights alone, by Newton's method with dA_i/dw_j = -side_ij/(2 |x_i - x_j|), until every area is
//           right to 1e-6 of the mean.
//
//   const Tiling cells = laguerre_tiling({2e-4, 2e-4}, seeds, areas, 5);
//
// In: periods along x and y (m), seeds (m), areas (m^2, taken in proportion). Out: the tiling; cell i belongs
// to seed i. Throws std::invalid_argument where no such tessellation is found.
#pragma once

#include "micro/geometry/tiling.h"

namespace turgor {
Tiling laguerre_tiling(const Vector<2> &periods, std::vector<Vector<2>> seeds, std::vector<double> areas,
                       unsigned int rounds);
}  // namespace turgor
