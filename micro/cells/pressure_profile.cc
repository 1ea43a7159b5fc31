#include "micro/cells/pressure_profile.h"

#include <algorithm>
#include <cmath>

namespace turgor {
std::vector<PressureShell> pressure_profile(const Particles<3> &particles,
                                            const std::vector<double> &pressure,
                                            const std::vector<double> &weight, const OuterCells &outer,
                                            const double thickness) {
  struct Sums {
    double w = 0., wp = 0., wpp = 0., n = 0.;
  };
  std::vector<Sums> sums(std::size_t(std::floor(outer.edge / thickness)) + 1);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double depth = outer.edge - (particles.position(i) - outer.centre).norm();
    Sums &s = sums[std::min(sums.size() - 1, std::size_t(std::max(0., depth) / thickness))];
    s.w += weight[i];
    s.wp += weight[i] * pressure[i];
    s.wpp += weight[i] * pressure[i] * pressure[i];
    s.n += 1.;
  }
  std::vector<PressureShell> shells;
  for (std::size_t k = 0; k < sums.size(); ++k)
    if (const Sums &s = sums[k]; s.w > 0.) {
      const double mean = s.wp / s.w;
      shells.push_back(
          {(double(k) + 0.5) * thickness, mean, std::sqrt(std::max(0., s.wpp / s.w - mean * mean)), s.n});
    }
  return shells;
}
}  // namespace turgor
