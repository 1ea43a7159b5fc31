// Tilings of one cell in its lattice; replicated() lays as many as wanted.
//
//   square    periods (L, 0), (0, L)
//   brick     a square of side L whose rows are moved by half a cell: periods (L, 0), (L/2, L), six corners
//             (thesis 3.3.2)
//   hexagon   regular, of the same area L^2, two sides upright: the brick's corners at other places
//
// In: side of the square of the same area (m).
#pragma once

#include "micro/geometry/tiling.h"

namespace turgor {
Tiling square_tiling(double side);
Tiling brick_tiling(double side);
Tiling hexagon_tiling(double side);
}  // namespace turgor
