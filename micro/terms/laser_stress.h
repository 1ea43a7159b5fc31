// The pull of two opposite laser beams at the surface of a cell between them (optical stretcher, thesis B.5):
// a stress along the outward normal,
//
//   sigma(alpha) = sigma_0 cos^2 alpha,   alpha: angle between the beams' axis and the node, seen from the
//   middle of the cell
//   sigma_0 = 2 (n_c - n_m) P/(pi R_beam^2 c)                                  B.26 (corrected: outward; 1.04
//     Pa at 1.1 W)
//
// P: power of each beam (W), n_c, n_m: refractive indices of cell and medium, R_beam: m, c: speed of light as
// in the thesis, 3e8 m/s.
#pragma once

#include "micro/terms/cell_surfaces.h"

#include <numbers>

namespace turgor {
struct LaserBeams {
  double power = 1.1, beam_radius = 8.2e-6, cell_index = 1.36, medium_index = 1.33;

  double stress() const {
    return 2. * (cell_index - medium_index) * power / (std::numbers::pi * beam_radius * beam_radius * 3e8);
  }  ///< Pa, sigma_0
};

/// f += the forces (N) of sigma_0 (Pa) on the nodes of a cell. axis: unit vector. The area that a
/// node stands for, with its normal, is dV/dx.
inline void add_laser_forces(const CellSurfaces &surfaces, const Particles<3> &particles,
                             const std::size_t cell, const Vector<3> &axis, const double sigma_0,
                             Particles<3>::Components &f) {
  const Group &group = particles.groups[cell];
  std::vector<Vector<3>> area(group.wall_count(), Vector<3>::Zero());
  surfaces.add_volume_gradient(particles, cell, area);
  Vector<3> middle = Vector<3>::Zero();
  for (std::uint32_t i = group.begin; i < group.fluid; ++i)
    middle += particles.position(i) / double(group.wall_count());
  for (std::uint32_t i = group.begin; i < group.fluid; ++i) {
    const double cosine = (particles.position(i) - middle).normalized().dot(axis);
    const Vector<3> pull = sigma_0 * cosine * cosine * area[i - group.begin];
    for (int d = 0; d < 3; ++d) f[d][i] += pull[d];
  }
}
}  // namespace turgor
