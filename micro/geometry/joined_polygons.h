// A tiling from polygons given one by one: corners nearer than a tolerance are one vertex, counted modulo the
// periods, and a corner that lies on another polygon's side becomes a corner of that polygon too (as in a
// brick wall). Clockwise polygons are turned round.
//
//   const Tiling cells = join_polygons(polygons, &lattice, 1e-9);   // periodic; nullptr: a bounded piece
//
// In: corners (m), lattice (m, columns are periods), tolerance (m). Throws std::invalid_argument for what is
// no tiling (Tiling::check).
#pragma once

#include "micro/geometry/tiling.h"

namespace turgor {
Tiling join_polygons(const std::vector<std::vector<Vector<2>>> &polygons, const Tensor2<2> *lattice,
                     double tolerance);
}  // namespace turgor
