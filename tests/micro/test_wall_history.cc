// Yielding and failure of the cell wall: the law of Eq. 3.8, rings with broken and flown bonds, the two
// processes.
#include "micro/processes/failure.h"
#include "micro/processes/wall_yielding.h"
#include "micro/laws/neo_hookean_wall.h"
#include "micro/terms/ring_wall.h"
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <memory>
#include <numbers>

using namespace turgor;

namespace {
constexpr double G = 100., z0 = 50e-6;

// A ring of n nodes on a wobbly ellipse: every bond has a stretch of its own.
struct Ring {
  static constexpr unsigned int n = 12;
  ParticleSystem<2> system;
  RingWall *wall = nullptr;

  explicit Ring(const NeoHookeanWall &law, const double size = 1.) {
    Particles<2> &p = system.particles;
    p.resize(n);
    p.groups.push_back({0, n, n});
    RingShape shape;
    for (unsigned int k = 0; k < n; ++k) {
      const double t = 2. * std::numbers::pi * k / n;
      p.x[0][k] = size * 20e-6 * std::cos(t) * (1. + 0.05 * std::sin(3. * t));
      p.x[1][k] = size * 18e-6 * std::sin(t);
      p.inverse_mass[k] = 1e12;
      shape.rest_length.push_back((10. + 0.1 * k) * 1e-6);
      shape.rest_angle.push_back(k % 3 == 0 ? 0.9 : 0.3);
      shape.hinge.push_back(1e-16 / 10e-6);
    }
    wall = &system.add(std::make_unique<RingWall>(law, std::vector<RingShape>{shape}, 10e-6, 1e-12));
  }

  void require_conservative() {
    Particles<2> &p = system.particles;
    system.compute_forces();
    const Particles<2>::Components f = p.f;
    double fx = 0., fy = 0., moment = 0., scale = 0.;
    for (unsigned int k = 0; k < n; ++k) {
      fx += f[0][k];
      fy += f[1][k];
      moment += p.x[0][k] * f[1][k] - p.x[1][k] * f[0][k];
      scale = std::max(scale, std::hypot(f[0][k], f[1][k]));
    }
    BOOST_TEST(std::hypot(fx, fy) < 1e-14 * n * scale);
    BOOST_TEST(std::abs(moment) < 1e-14 * n * scale * 20e-6);
    for (unsigned int k = 0; k < n; ++k)
      for (int d = 0; d < 2; ++d) {
        const double h = 1e-10, x = p.x[d][k];
        p.x[d][k] = x + h;
        const double up = system.potential_energy();
        p.x[d][k] = x - h;
        const double down = system.potential_energy();
        p.x[d][k] = x;
        // (h/l)^2 of the third derivative, and the energy's round-off over the step
        BOOST_TEST(std::abs((up - down) / (2. * h) + f[d][k]) < 1e-7 * scale);
      }
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(wall_history)

BOOST_AUTO_TEST_CASE(yield_by_hand) {
  const WallYield yield{15., 0.9};
  BOOST_TEST(yield.share(0.5) == 1.);
  BOOST_TEST(yield.share(1.) == 1.);
  BOOST_TEST(yield.share(1. + 1. / 15.) == 1. - 0.45, boost::test_tools::tolerance(1e-14));  // atan 1 = pi/4
  BOOST_TEST(yield.share(1e9) == 0.1, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(!WallYield{}.active());
}

BOOST_AUTO_TEST_CASE(yielding_law_is_consistent) {
  for (const WallYield yield : {WallYield{15., 0.9}, WallYield{1., 0.5}, WallYield{1000., 1.}}) {
    const NeoHookeanWall wall(G, z0, 0.5, yield), elastic(G, z0, 0.5);
    for (const double lambda : {0.7, 0.99, 1.003, 1.02, 1.1, 1.7, 4.}) {
      BOOST_TEST(wall.force(lambda) == elastic.force(lambda) * yield.share(lambda),
                 boost::test_tools::tolerance(1e-15));
      double both;
      wall.force(lambda, both);
      BOOST_TEST(both == wall.derivative(lambda));
      // steps well below the width 1/A of the transition, and not across lambda = 1 where g has a kink
      const double h = 1e-3 / (1. + yield.sharpness), unit = G * z0;
      const auto slope = [&](const auto &f) {
        return (8. * (f(lambda + h) - f(lambda - h)) - (f(lambda + 2. * h) - f(lambda - 2. * h))) / (12. * h);
      };
      BOOST_TEST(std::abs(slope([&](double l) { return wall.force(l); }) - both) < 1e-7 * unit);
      BOOST_TEST(std::abs(slope([&](double l) { return wall.energy(l); }) - wall.force(lambda)) <
                 1e-9 * unit);
    }
  }
  // without yielding: the same bits
  const NeoHookeanWall none(G, z0, 0.5, WallYield{15., 0.}), plain(G, z0, 0.5);
  for (const double lambda : {0.8, 1.03, 2.}) {
    BOOST_TEST(none.force(lambda) == plain.force(lambda));
    BOOST_TEST(none.energy(lambda) == plain.energy(lambda));
  }
}

BOOST_AUTO_TEST_CASE(yielding_stretch) {
  const NeoHookeanWall wall(G, z0, 0.5, WallYield{15., 0.9});
  for (const double tension : {1e-6, 1e-4, 5e-4})
    BOOST_TEST(wall.force(wall.stretch_at(tension)) == tension, boost::test_tools::tolerance(1e-12));
  // all stiffness lost: F_el g has a maximum, and beyond it there is no stretch
  const NeoHookeanWall soft(G, z0, 0.5, WallYield{1000., 1.});
  BOOST_CHECK_THROW(soft.stretch_at(5e-4), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(ring_with_history_is_conservative) {
  Ring plain(NeoHookeanWall(G, z0, 0.5));
  plain.require_conservative();
  Ring ring(NeoHookeanWall(G, z0, 0.5, WallYield{15., 0.9}), 1.05);
  ring.require_conservative();
  const auto damage = std::make_shared<WallDamage>(1, Ring::n, Ring::n);
  damage->cells[0].bond_broken[4] = damage->cells[0].bond_broken[11] = 1;
  ring.wall->set_damage(damage);
  ring.require_conservative();
  // node 5 is joined to node 6 only: pulled along that bond, no hinge
  const Particles<2> &p = ring.system.particles;
  ring.system.compute_forces();
  const double ex = p.x[0][6] - p.x[0][5], ey = p.x[1][6] - p.x[1][5], l = std::hypot(ex, ey);
  BOOST_TEST(ring.wall->tension(p, 0, 4) == 0.);
  const auto flow = std::make_shared<WallFlow>(1, Ring::n);
  flow->permanent[0][5] = 1.02;
  ring.wall->set_flow(flow);
  ring.require_conservative();
  BOOST_TEST(ring.wall->tension(p, 0, 5) == NeoHookeanWall(G, z0, 0.5).force(l / (10.5e-6 * 1.02)),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(bonds_break_beyond_the_critical_stretch) {
  Ring ring(NeoHookeanWall(G, z0, 0.5), 1.1);
  const auto damage = std::make_shared<WallDamage>(1, Ring::n, Ring::n);
  ring.wall->set_damage(damage);
  const Particles<2> &p = ring.system.particles;
  double most = 0.;
  std::size_t at = 0;
  for (std::size_t k = 0; k < Ring::n; ++k)
    if (ring.wall->stretch(p, 0, k) > most) {
      most = ring.wall->stretch(p, 0, k);
      at = k;
    }
  Failure<2> none(*ring.wall, damage, most * (1. + 1e-9));
  BOOST_TEST(none.apply(ring.system, nullptr).empty());
  BOOST_TEST(!damage->cells[0].failed());
  Failure<2> one(*ring.wall, damage, most * (1. - 1e-9));
  const auto broken = one.apply(ring.system, nullptr);
  BOOST_REQUIRE(broken.size() == 1u);
  BOOST_TEST(broken[0].second == at);
  BOOST_TEST(damage->failed_cells() == 1u);
  BOOST_TEST(bool(damage->cells[0].face_gone[at]));
  BOOST_TEST(one.apply(ring.system, nullptr).empty());  // once is enough
  WallDamage read(1, Ring::n, Ring::n);
  restore(archived(*damage), read);
  BOOST_TEST(read.cells[0].bond_broken == damage->cells[0].bond_broken);
  BOOST_TEST(read.failed_cells() == 1u);
}

BOOST_AUTO_TEST_CASE(plastic_bonds_follow_the_curve_and_unload_elastically) {
  const NeoHookeanWall law(G, z0, 0.5, WallYield{15., 0.9}), elastic = law.elastic();
  Ring ring(law);
  const auto flow = std::make_shared<WallFlow>(1, Ring::n);
  ring.wall->set_flow(flow);
  Particles<2> &p = ring.system.particles;
  const WallYielding yielding(*ring.wall, flow);
  const Particles<2>::Components x0 = p.x;
  const auto resize = [&](const double size) {
    for (int d = 0; d < 2; ++d)
      for (std::size_t k = 0; k < Ring::n; ++k) p.x[d][k] = size * x0[d][k];
  };
  resize(1.3);
  BOOST_TEST(yielding.apply(ring.system));
  BOOST_TEST(!yielding.apply(ring.system));  // nothing more at the same stretch
  for (std::size_t k = 0; k < Ring::n; ++k)
    if (ring.wall->stretch(p, 0, k) > 1.)
      BOOST_TEST(ring.wall->tension(p, 0, k) == law.force(ring.wall->stretch(p, 0, k)),
                 boost::test_tools::tolerance(1e-9));
  ring.require_conservative();
  const std::vector<double> before = flow->permanent[0];
  resize(1.25);
  BOOST_TEST(!yielding.apply(ring.system));
  BOOST_TEST(flow->permanent[0] == before);
  for (std::size_t k = 0; k < Ring::n; ++k)
    BOOST_TEST(ring.wall->tension(p, 0, k) == elastic.force(ring.wall->stretch(p, 0, k) / before[k]),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
