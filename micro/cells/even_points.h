// Points spread evenly inside a polygon of any shape: as many as asked, each in the middle of a piece of the
// same area.
//
// The polygon is cut across y into strips about as high as a piece is wide, a whole number of pieces in each,
// and every strip across x into its pieces. A map of a square onto the shape (Coons' patch) would be simpler,
// but in a hexagon its pieces differ by a factor of four in area, and fluid laid so is nearly three times as
// dense in the corners, with a step a third of that of fluid laid evenly.
//
//   for (const Vector<2> &x : even_points(ring, 100)) ...
//     // strip by strip upwards, in a strip from left to right
#pragma once

#include "micro/geometry/tensor.h"

#include <vector>

namespace turgor {
struct EvenPoint {
  Vector<2> at, size;  ///< m, centre of area of its piece, and width and height of it
};

/// ring: m, counter-clockwise, without crossings. Throws std::runtime_error where it encloses no area.
std::vector<EvenPoint> even_points(const std::vector<Vector<2>> &ring, std::size_t count);
}  // namespace turgor
