// A 2D cell whose wall is held: fluid settled inside a given ring, for flows with a closed form; the viscous
// forces and their matrix.
#pragma once

#include "micro/laws/counter_random.h"
#include "micro/engine/kick_drift_kick.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/sph_fluid.h"

#include <Eigen/Dense>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace turgor::test {
struct HeldCell {
  static constexpr double dx = 1e-5, depth = 5e-5, modulus = 6e6;  ///< m, m, Pa
  ParticleSystem<2> system;
  SphFluid<2> *fluid = nullptr;
  double area = 0.;  ///< m^2

  /// ring: corners of the wall in spacings, counter-clockwise; inside: whether a lattice point (in spacings)
  /// belongs to the fluid.
  HeldCell(const std::vector<Vector<2>> &ring, const std::function<bool(const Vector<2> &)> &inside,
           const SphFluidParameters &form, const unsigned int steps = 4000) {
    std::vector<Vector<2>> points;
    for (int a = -50; a < 50; ++a)
      for (int b = -40; b < 40; ++b)
        if (const Vector<2> x(a + 0.5, b + 0.5); inside(x)) points.push_back(x);
    const std::size_t nw = ring.size();
    Particles<2> &p = system.particles;
    p.resize(nw + points.size());
    p.groups = {Group{0, std::uint32_t(nw), std::uint32_t(p.size())}};
    for (std::size_t i = 0; i < p.size(); ++i)
      for (int d = 0; d < 2; ++d)
        p.x[d][i] =
            dx * (i < nw ? ring[i][d] : points[i - nw][d] + 0.2 * (2. * random_uniform(7, 2 * i + d) - 1.));
    for (std::size_t k = 0; k < nw; ++k)
      area += 0.5 * (p.x[0][k] * p.x[1][(k + 1) % nw] - p.x[1][k] * p.x[0][(k + 1) % nw]);
    const EquationOfState eos(1000., modulus, -100e3);
    const double mass = eos.density_at(2e5) * area * depth / double(points.size());
    for (std::size_t i = nw; i < p.size(); ++i) p.inverse_mass[i] = 1. / mass;
    SphFluidParameters parameters = form;
    parameters.support = 2.6 * dx;
    parameters.skin = 0.2 * dx;
    parameters.depth = depth;
    parameters.ordering = 0.01 * modulus;
    fluid = &system.add(std::make_unique<SphFluid<2>>(parameters, eos, std::vector<double>{mass}));
    KickDriftKick<2> integrator(system);
    system.compute_forces();
    const double dt = 0.8 * system.stable_time_step(), crossing = std::sqrt(area) / eos.sound_speed(1000.);
    for (unsigned int s = 0; s < steps; ++s)
      integrator.step(dt, (s < 0.2 * steps || s > 0.8 * steps ? 0.5 : 0.1) / crossing);
    stop();
  }

  std::size_t wall() const { return system.particles.groups[0].fluid; }
  std::size_t particles() const { return system.particles.size() - wall(); }
  double particle_volume() const { return area * depth / double(particles()); }  ///< m^3
  void stop() {
    for (auto &v : system.particles.v) std::fill(v.begin(), v.end(), 0.);
  }

  /// How many particles stand between `from` and `to` spacings before the nearest face's line.
  int layer(const double from, const double to) const {
    const Particles<2> &p = system.particles;
    int count = 0;
    for (std::size_t i = wall(); i < p.size(); ++i) {
      double least = HUGE_VAL;
      for (std::size_t k = 0; k < wall(); ++k) {
        const Vector<2> a = p.position(k), e = p.position((k + 1) % wall()) - a, r = p.position(i) - a;
        const double t = std::clamp(r.dot(e) / e.squaredNorm(), 0., 1.);
        least = std::min(least, (r - t * e).norm());
      }
      count += least >= from * dx && least < to * dx;
    }
    return count;
  }

  /// N: viscous forces for the velocities that the particles have (viscosity 1 Pa s); x of all, then y of
  /// all.
  Eigen::VectorXd forces() {
    fluid->set_viscosity(1.);
    const auto f = fluid->viscous_forces(system.particles, 0);
    Eigen::VectorXd both(2 * f[0].size());
    both << Eigen::Map<const Eigen::VectorXd>(f[0].data(), std::ptrdiff_t(f[0].size())),
        Eigen::Map<const Eigen::VectorXd>(f[1].data(), std::ptrdiff_t(f[1].size()));
    return both;
  }

  /// N s/m: the symmetric matrix of the fluid particles, the wall at rest: force = - K v; x of all, then y of
  /// all.
  Eigen::MatrixXd matrix() {
    stop();
    const std::size_t n = particles();
    Eigen::MatrixXd K(2 * n, 2 * n);
    for (int d = 0; d < 2; ++d)
      for (std::size_t i = 0; i < n; ++i) {
        system.particles.v[d][wall() + i] = 1.;
        K.col(d * n + i) = -of_fluid(forces());
        system.particles.v[d][wall() + i] = 0.;
      }
    return 0.5 * (K + K.transpose());
  }
  /// The fluid's part of forces().
  Eigen::VectorXd of_fluid(const Eigen::VectorXd &f) const {
    const std::size_t n = particles(), all = system.particles.size();
    Eigen::VectorXd part(2 * n);
    part << f.segment(wall(), n), f.segment(all + wall(), n);
    return part;
  }
};
}  // namespace turgor::test
