// The viscous forces of a cell for any velocity, 2D and 3D, and what they add up to.
#pragma once

#include "micro/laws/counter_random.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/sph_fluid.h"

#include <cmath>
#include <functional>

namespace turgor::test {
template <int dim>
class ViscousForces {
 public:
  using Components = typename Particles<dim>::Components;

  /// Of the system's one group. mu: Pa s.
  ViscousForces(ParticleSystem<dim> &system_, SphFluid<dim> &fluid_, const double mu = 1.)
      : system(system_), fluid(fluid_) {
    fluid.set_viscosity(mu);
    system.compute_forces();
  }

  /// N, of the velocity field (m/s).
  const Components &of(const std::function<Vector<dim>(const Vector<dim> &)> &field) {
    Particles<dim> &p = system.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector<dim> v = field(p.position(i));
      for (int d = 0; d < dim; ++d) p.v[d][i] = v[d];
    }
    return of_velocities();
  }
  /// N, of velocities between -1 and 1 m/s.
  const Components &of_noise(const unsigned int seed) {
    Particles<dim> &p = system.particles;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (int d = 0; d < dim; ++d) p.v[d][i] = 2. * random_uniform(seed, dim * i + d) - 1.;
    return of_velocities();
  }
  /// N, of the velocities that the particles have.
  const Components &of_velocities() { return f = fluid.viscous_forces(system.particles, 0); }

  // Of the last forces:
  double largest() const  ///< N
  {
    double most = 0.;
    for (int d = 0; d < dim; ++d)
      for (const double a : f[d]) most = std::max(most, std::abs(a));
    return most;
  }
  /// N m: - sum f (x) x, stress times volume.
  Tensor2<dim> virial() const {
    Tensor2<dim> sum = Tensor2<dim>::Zero();
    for (std::size_t i = 0; i < f[0].size(); ++i) sum -= force(i) * system.particles.position(i).transpose();
    return sum;
  }
  double power() const  ///< W
  {
    double sum = 0.;
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = 0; i < f[d].size(); ++i) sum += f[d][i] * system.particles.v[d][i];
    return sum;
  }
  double total_force() const  ///< N
  {
    Vector<dim> sum = Vector<dim>::Zero();
    for (std::size_t i = 0; i < f[0].size(); ++i) sum += force(i);
    return sum.norm();
  }
  /// N m: the antisymmetric part of sum x (x) f.
  double total_torque() const { return (virial() - virial().transpose()).norm(); }
  Vector<dim> force(const std::size_t i) const {
    Vector<dim> a;
    for (int d = 0; d < dim; ++d) a[d] = f[d][i];
    return a;
  }

 private:
  ParticleSystem<dim> &system;
  SphFluid<dim> &fluid;
  Components f;
};
}  // namespace turgor::test
