// A small patch of SPH cells for the tests of the fluids: disturbed, so that no force is zero by
// symmetry, or with its fluid on a lattice, so that sums can be done by hand.
#pragma once

#include "micro/cells/parenchyma.h"
#include "micro/cells/sph_parenchyma.h"
#include "micro/laws/counter_random.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace turgor::test {
struct SmallPatch {
  ParenchymaParameters cell;
  SphParameters sph;
  double box_shear = 0.;  ///< of the period, against the cells

  SmallPatch() {
    cell.nodes_per_side = 10;
    cell.fluid_viscosity = 0.;
    sph.particles_per_side = 9;
  }

  std::unique_ptr<SphPatch> disturbed(const unsigned int columns, const unsigned int rows) const {
    return disturbed(columns, rows, cell.fluid_viscosity);
  }

  /// Jittered particles with random velocities (1 m/s).
  std::unique_ptr<SphPatch> disturbed(const unsigned int columns, const unsigned int rows,
                                      const double viscosity) const {
    ParenchymaParameters p = cell;
    p.fluid_viscosity = viscosity;
    const CellLayout patch = make_parenchyma(p, columns, rows, true, true);
    auto result = make_sph_patch(patch, sph, unannealed_cell(patch, sph));
    Particles<2> &particles = result->system.particles;
    for (std::size_t i = 0; i < particles.size(); ++i)
      for (int d = 0; d < 2; ++d) {
        particles.x[d][i] += 0.02 * patch.spacing * (2. * random_uniform(7, 2 * i + d) - 1.);
        particles.v[d][i] = 2. * random_uniform(8, 2 * i + d) - 1.;
      }
    result->system.box.H(0, 1) = box_shear * result->system.box.H(1, 1);
    return result;
  }

  /// One cell with its fluid on a square lattice, at rest.
  std::unique_ptr<SphPatch> lattice() const {
    const CellLayout patch = make_parenchyma(cell, 1, 1, true, true);
    CellContents reference = unannealed_cell(patch, sph);
    const unsigned int n = sph.particles_per_side;
    for (unsigned int k = 0; k < n * n; ++k) {
      reference.x[reference.wall_count + k] = (k % n + 0.5) * cell.period / n;
      reference.y[reference.wall_count + k] = (k / n + 0.5) * cell.period / n;
    }
    return make_sph_patch(patch, sph, reference);
  }

  /// Of lattice(): the particle in the middle of the cell.
  std::uint32_t middle(const SphPatch &patch) const {
    return patch.system.particles.groups[0].fluid + sph.particles_per_side * sph.particles_per_side / 2;
  }
};

/// N, of any component of any particle.
inline double largest_force(const Particles<2> &particles) {
  double largest = 0.;
  for (int d = 0; d < 2; ++d)
    for (const double f : particles.f[d]) largest = std::max(largest, std::abs(f));
  return largest;
}

/// N, sum over all particles: momentum is kept if it is zero.
inline Vector<2> total_force(const Particles<2> &particles) {
  Vector<2> total = Vector<2>::Zero();
  for (std::size_t i = 0; i < particles.size(); ++i) total += Vector<2>(particles.f[0][i], particles.f[1][i]);
  return total;
}

/// N, between the forces of two evaluations of the same particles.
inline double largest_difference(const Particles<2> &one, const Particles<2> &other) {
  double largest = 0.;
  for (int d = 0; d < 2; ++d)
    for (std::size_t i = 0; i < one.size(); ++i)
      largest = std::max(largest, std::abs(one.f[d][i] - other.f[d][i]));
  return largest;
}
}  // namespace turgor::test
