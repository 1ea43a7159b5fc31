// A small 2D cell for the tests of the fluid: a ring whose fluid stands on a square lattice, a little
// disturbed, and that can be opened.
#pragma once

#include "micro/laws/counter_random.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/sph_fluid.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace turgor::test {
/// A round cell in 2D, its fluid on a lattice.
struct SmallRound {
  double radius = 50e-6, depth = 50e-6;
  unsigned int nodes = 60;
  EquationOfState eos{1000., 6e6, -100e3};
  ParticleSystem<2> system;
  SphFluid<2> *fluid = nullptr;
  std::shared_ptr<WallDamage> damage;
  double spacing = 50e-6 / 8.;

  explicit SmallRound(const double density_ratio = 1.005) {
    std::vector<Vector<2>> points;
    for (int a = -9; a < 9; ++a)
      for (int b = -9; b < 9; ++b) {
        const Vector<2> x = spacing * Vector<2>(a + 0.5, b + 0.5);
        if (x.norm() < radius - 0.45 * spacing) points.push_back(x);
      }
    Particles<2> &p = system.particles;
    p.resize(nodes + points.size());
    p.groups = {Group{0, nodes, std::uint32_t(p.size())}};
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double angle = 2. * std::numbers::pi * double(i) / nodes;
      const Vector<2> x =
          i < nodes ? Vector<2>(radius * std::cos(angle), radius * std::sin(angle)) : points[i - nodes];
      for (int d = 0; d < 2; ++d) p.x[d][i] = x[d] + 0.1 * spacing * (2. * random_uniform(7, 2 * i + d) - 1.);
    }
    const double mass =
        density_ratio * 1000. * std::numbers::pi * radius * radius * depth / double(points.size());
    for (double &m : p.inverse_mass) m = 1. / mass;
    SphFluidParameters parameters;
    parameters.support = 2.6 * spacing;
    parameters.skin = 0.3 * spacing;
    parameters.depth = depth;
    parameters.ordering = 0.01 * 6e6;
    parameters.barrier = 6e6;
    damage = std::make_shared<WallDamage>(1, nodes, nodes);
    fluid = &system.add(std::make_unique<SphFluid<2>>(parameters, eos, std::vector<double>{mass}, damage));
  }
  void open(const unsigned int first, const unsigned int count) {
    for (unsigned int k = first; k < first + count; ++k)
      damage->cells[0].face_gone[k % nodes] = damage->cells[0].bond_broken[k % nodes] = 1;
    damage->cells[0].broken = count;
    fluid->forget_lists(0);
  }
};
}  // namespace turgor::test
