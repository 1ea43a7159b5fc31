// What is asked of particles that come to rest, and done to them when they have.
//
//   const double residual = largest_force(system.particles) / scale;   // forces of now
//   halt(system.particles);
#pragma once

#include "micro/engine/particles.h"

#include <algorithm>
#include <cmath>

namespace turgor {
/// N, of the force on a particle; not a number where one is none. free: of those that may move alone.
template <int dim>
double largest_force(const Particles<dim> &p, const bool free = false) {
  double most = 0.;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (free && !(p.inverse_mass[i] > 0.)) continue;
    double squared = 0.;
    for (int d = 0; d < dim; ++d) squared += p.f[d][i] * p.f[d][i];
    if (!(squared <= most))  // keeps what is no number
      most = squared;
  }
  return std::sqrt(most);
}

/// Velocities zero.
template <int dim>
void halt(Particles<dim> &p) {
  for (int d = 0; d < dim; ++d) std::fill(p.v[d].begin(), p.v[d].end(), 0.);
}
}  // namespace turgor
