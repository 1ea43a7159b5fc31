// Volume and radius of a ball.
#pragma once

#include <cmath>
#include <numbers>

namespace turgor {
/// m^3, of a radius in m.
inline double sphere_volume(const double radius) {
  return 4. / 3. * std::numbers::pi * radius * radius * radius;
}
/// m, of a volume in m^3.
inline double sphere_radius(const double volume) { return std::cbrt(volume / (4. / 3. * std::numbers::pi)); }
}  // namespace turgor
