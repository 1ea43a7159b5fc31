// Drag of a square array of cylinders in Stokes flow across them, along a side of the square, by expanding
// the stream function about a cylinder and meeting the symmetries of the cell at its sides by least squares
// (as Sangani and Acrivos, Int. J. Multiphase Flow 8, 1982, 193, whose table it reproduces: 15.56, 51.53 and
// 532.55 at c = 0.05, 0.2 and 0.5), and their series for dilute arrays. c: share of the area that is solid;
// the drag is over viscosity and superficial speed, of a metre of cylinder and with what the mean gradient of
// pressure does to it: k = period^2/drag.
#pragma once

#include <cmath>

namespace turgor {
/// c from 0.001 to 0.55; throws std::invalid_argument beyond.
double cylinder_array_drag(double c);

/// Up to c^3: 1.5 % at c = 0.2.
inline double dilute_array_drag(const double c) {
  return 4. * 3.141592653589793 / (-0.5 * std::log(c) - 0.738 + c - 0.887 * c * c + 2.038 * c * c * c);
}
}  // namespace turgor
