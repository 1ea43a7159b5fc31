// F = -dE/dx by central differences of fourth order, for any system.
#pragma once

#include "micro/engine/particle_system.h"

#include <algorithm>
#include <cmath>

namespace turgor::test {
/// N, of any component of any particle.
template <int dim>
double largest_component(const Particles<dim> &p) {
  double largest = 0.;
  for (int d = 0; d < dim; ++d)
    for (const double f : p.f[d]) largest = std::max(largest, std::abs(f));
  return largest;
}

/// Largest difference between force and slope of the energy over the largest force; of every `stride`-th
/// particle. h: m.
template <int dim>
double slope_error(ParticleSystem<dim> &system, const double h, const std::size_t stride) {
  system.compute_forces();
  const Particles<dim> at = system.particles;
  double worst = 0.;
  for (std::size_t i = 0; i < at.size(); i += stride)
    for (int d = 0; d < dim; ++d) {
      double e[4];
      const double offset[4] = {-2 * h, -h, h, 2 * h};
      for (int k = 0; k < 4; ++k) {
        system.particles.x[d][i] = at.x[d][i] + offset[k];
        system.compute_forces();
        e[k] = system.potential_energy();
      }
      system.particles.x[d][i] = at.x[d][i];
      worst = std::max(worst, std::abs(at.f[d][i] + (e[0] - 8. * e[1] + 8. * e[2] - e[3]) / (12. * h)));
    }
  system.compute_forces();
  return worst / largest_component(at);
}

/// Largest squared frequency (1/s^2) of the particles [from, to), the others held, by power iteration on
/// differences of forces.
template <int dim>
double highest_frequency_squared(ParticleSystem<dim> &system, const std::uint32_t from,
                                 const std::uint32_t to, const double h, const int iterations) {
  const Particles<dim> at = system.particles;
  std::vector<double> mode((to - from) * dim);
  for (std::size_t k = 0; k < mode.size(); ++k) mode[k] = std::sin(12.9898 * double(k * k % 1013));
  double value = 0.;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    double norm = 0.;
    for (const double m : mode) norm += m * m;
    std::vector<double> image(mode.size(), 0.);
    for (int side = 0; side < 2; ++side) {
      for (std::uint32_t i = from; i < to; ++i)
        for (int d = 0; d < dim; ++d)
          system.particles.x[d][i] =
              at.x[d][i] + (side ? h : -h) * mode[(i - from) * dim + d] / std::sqrt(norm);
      system.compute_forces();
      for (std::uint32_t i = from; i < to; ++i)
        for (int d = 0; d < dim; ++d)
          image[(i - from) * dim + d] -=
              (side ? 1. : -1.) * system.particles.f[d][i] * at.inverse_mass[i] / (2. * h);
    }
    value = 0.;
    for (std::size_t k = 0; k < mode.size(); ++k) value += image[k] * mode[k] / std::sqrt(norm);
    mode = image;
  }
  system.particles.x = at.x;
  return value;
}
}  // namespace turgor::test
