// Air spaces of a tissue: where walls are not tied, the faces around each place at which cells meet.
//
// A face is the stretch of a ring between two tied nodes that follow each other. From its end a tie leads to
// the cell on the other side and to the beginning of the next face, moved by the tie's periods, and so on
// until the way comes back: a face belongs to one air space, an air space to one place where cells meet (or
// to several, where the wall between them is too short to be tied).
//
//   layout.air = find_air_spaces(layout);      // of a tissue that is periodic both ways
//   const double air = air_area(layout, x, H) / H.determinant();
//
// In and out: m, m^2.
#pragma once

#include "micro/cells/cell_layout.h"

namespace turgor {
/// Throws std::invalid_argument with a sentence: a cell that is tied to nothing, air without end.
std::vector<AirSpace> find_air_spaces(const CellLayout &layout);

/// m^2, between the middle lines of the walls of one space; negative where they have passed each other.
double air_area(const CellLayout &layout, const AirSpace &space, const std::vector<double> &x,
                const Tensor2<2> &H);

/// m, of half the middle lines around it.
double air_rim(const CellLayout &layout, const AirSpace &space, const std::vector<double> &x);
}  // namespace turgor
