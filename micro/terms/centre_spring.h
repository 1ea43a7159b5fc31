// Holds how far deformable cells are along an axis by a spring: one cell from the origin, or two from each
// other,
//
//   E = 1/2 k (s - s_0)^2,   s = e . (mean place of the last cell's nodes - that of the first, if there are
//     two)
//
// so that a cell is drawn off at a given displacement, not at a given force, of which every jump would be the
// last. s_0 moves by `speed` (m/s) at the end of each step. The pull is spread evenly over the nodes. e: unit
// vector; k: N/m; s_0: m. Implicit steps see all of k.
//
//   auto &grip = system.add(std::make_unique<CentreSpring>(Vector<3>::UnitZ(), 0.01));
//   grip.hold(grip.distance());   grip.speed = 1e-9;   grip.force_of_step()        N, by which it pulls
#pragma once

#include "micro/engine/term.h"
#include "micro/solve/motion_matrix.h"
#include "micro/terms/cell_surfaces.h"
#include "run/archive.h"

#include <stdexcept>

namespace turgor {
class CentreSpring final : public Term<3> {
 public:
  CentreSpring(const Vector<3> &along, const double stiffness_) : e(along), stiffness(stiffness_) {}

  double speed = 0.;  ///< m/s, of s_0

  std::string name() const override { return "centre_spring"; }
  void declare(Particles<3> &particles) override {
    if (particles.groups.empty() || particles.groups.size() > 2)
      throw std::logic_error("a spring holds one cell or two");
  }
  /// From now on, at s_0 (m).
  void hold(const double at) {
    s0 = at;
    holds = true;
  }
  double distance() const { return s; }                               ///< m, where forces were last asked
  double force() const { return holds ? stiffness * (s0 - s) : 0.; }  ///< N, there; positive: it pulls apart
  /// N, at the end of the last step, before s_0 moved on.
  double force_of_step() const { return felt; }
  double power() const { return force() * speed; }  ///< W, on the cells

  void prepare(const Particles<3> &particles, const Box<3> &, unsigned int, bool) override {
    s = 0.;
    for (std::size_t group = 0; group < particles.groups.size(); ++group) {
      const Group &g = particles.groups[group];
      double sum = 0.;
      for (std::uint32_t i = g.begin; i < g.end; ++i) sum += e.dot(particles.position(i));
      s += share(particles, group) * sum;
    }
  }
  void add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) override {
    const Group &g = particles.groups[group];
    const Vector<3> pull = share(particles, group) * force() * e;
    for (std::uint32_t i = g.begin; i < g.end; ++i) add_force(particles, i, pull);
  }
  double energy(const Particles<3> &, const Box<3> &, const std::size_t group) const override {
    return group == 0 && holds ? 0.5 * stiffness * (s - s0) * (s - s0) : 0.;
  }
  void collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) override {
    if (h == 0. || !holds) return;
    std::vector<Vector<3>> g(particles.size());
    for (std::size_t group = 0; group < particles.groups.size(); ++group)
      for (std::uint32_t i = particles.groups[group].begin; i < particles.groups[group].end; ++i)
        g[i] = share(particles, group) * e;
    matrix.whole<3>(0, g, h * stiffness);
  }
  void advance(const Particles<3> &, const double dt) override {
    felt = force();
    s0 += dt * speed;
  }
  void archive(Archive &a, Particles<3> &) override { a(s0, speed, felt, holds); }

 private:
  /// Of a node of the group in s.
  static double share(const Particles<3> &particles, const std::size_t group) {
    return (group + 1 < particles.groups.size() ? -1. : 1.) / double(particles.groups[group].wall_count());
  }

  Vector<3> e;
  double stiffness, s = 0., s0 = 0., felt = 0.;
  bool holds = false;
};
}  // namespace turgor
