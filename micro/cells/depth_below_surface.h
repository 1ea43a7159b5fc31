// Which cells of a cluster lie deeper than a rim below its surface, where the surface is that near by and not
// the mean one of the whole.
//
//   depth of a cell   E(n) - r, r and n: its distance and direction from the centroid
//   E(n)              mean distance of the outermost cells (at least half exposed, outer_cells.h) about that
//                     direction plus one mean radius: weights 1 - d^2/L^2, d: how far they are from it to the
//                     side at the mean edge, L = 4 mean radii, some twenty cells
//
// Over all directions at once E is the thesis's mean edge (5.4.2). That one lets whatever stands out by more
// than the rim grow throughout and run ahead, while cells on the ground of a wide cleft rest: lobes grow
// without end. Why a mean and not the nearest outer cell: among scattered outer cells the nearest lies deeper
// than most, and a rim counted from it is a sixth too fast.
//
// In: particles with radius (m), their outer cells, rim (m). Out: of each cell 1 where it is deeper, 0
// otherwise.
//
//   const std::vector<unsigned char> deep = deeper_than(30e-6, particles, find_outer_cells(particles));
#pragma once

#include "micro/terms/outer_cells.h"

#include <vector>

namespace turgor {
std::vector<unsigned char> deeper_than(double rim, const Particles<3> &particles, const OuterCells &outer);
}  // namespace turgor
