#include "micro/scenes/stepped_cells.h"

#include <algorithm>
#include <cmath>

namespace turgor {
double SteppedCells::largest_force() const {
  const Particles<3>::Components &f = system.particles.f;
  double square = 0.;
  for (std::size_t i = 0; i < f[0].size(); ++i)
    square = std::max(square, f[0][i] * f[0][i] + f[1][i] * f[1][i] + f[2][i] * f[2][i]);
  return std::sqrt(square);
}
}  // namespace turgor
