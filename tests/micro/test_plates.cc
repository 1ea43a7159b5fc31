// Rigid plates: force and energy by hand, F = -dE/dx, work against energy, a plate with mass on a spring.
#include "micro/engine/kick_drift_kick.h"
#include "micro/engine/particle_system.h"
#include "micro/engine/respa.h"
#include "micro/terms/plates.h"
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;

namespace
{
/// Wall particles of one group, 1 kg each, no other force.
template <int dim>
void put(ParticleSystem<dim> &system, const std::vector<Vector<dim>> &positions)
{
  Particles<dim> &p = system.particles;
  const std::uint32_t n = std::uint32_t(positions.size());
  p.resize(n);
  p.groups = {{0, n, n}};
  for (std::uint32_t i = 0; i < n; ++i)
    {
      p.inverse_mass[i] = 1.;
      for (int d = 0; d < dim; ++d)
        p.x[d][i] = positions[i][d];
    }
}
} // namespace

BOOST_AUTO_TEST_SUITE(plates)

BOOST_AUTO_TEST_CASE(force_and_energy_by_hand)
{
  ParticleSystem<3> system;
  put<3>(system, {{0., 0., -0.1}, {0., 0., 0.05}, {0., 0., 1.2}});
  // Floor at z = 0, lid at z = 1, k = 10 N/m: depths 0.1 below the floor, 0.2 above the lid.
  Plates<3> &two = system.add(std::make_unique<Plates<3>>(
    std::vector<Plate>{{.axis = 2, .side = 1, .position = 0.}, {.axis = 2, .side = -1, .position = 1.}}, 10.));
  system.compute_forces();
  BOOST_TEST(system.particles.f[2][0] == 1., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(system.particles.f[2][1] == 0.);
  BOOST_TEST(system.particles.f[2][2] == -2., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(two.force(0) == 1., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(two.force(1) == 2., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(system.potential_energy() == 0.5 * 10. * (0.01 + 0.04), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(system.particles.f[0][0] == 0.); // no friction
}

BOOST_AUTO_TEST_CASE(force_is_the_slope_of_the_energy)
{
  ParticleSystem<2> system;
  put<2>(system, {{0.3, -0.02}, {0.1, 0.98}, {0.5, 1.07}});
  system.add(std::make_unique<Plates<2>>(std::vector<Plate>{{.side = 1, .position = 0.}, {.side = -1, .position = 1.}}, 3e3));
  system.compute_forces();
  const Particles<2>::Components f = system.particles.f;
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i)
    for (int d = 0; d < 2; ++d)
      {
        double e[2];
        for (int s = 0; s < 2; ++s)
          {
            const double x = system.particles.x[d][i];
            system.particles.x[d][i] = x + (s ? h : -h);
            system.compute_forces();
            e[s] = system.potential_energy();
            system.particles.x[d][i] = x;
          }
        // quadratic: exact but for round-off of the positions, k depth eps / h = 3e3 * 0.07 * 2.2e-16 / 1e-6
        BOOST_CHECK_SMALL(f[d][i] + (e[1] - e[0]) / (2. * h), 1e-7);
      }
}

// A particle is pushed from rest by a plate that comes at speed u: elastic bounce off a heavy wall, v = 2 u, work = m (2u)^2/2.
BOOST_AUTO_TEST_CASE(work_of_a_driven_plate_is_the_energy_gained)
{
  ParticleSystem<2> system;
  put<2>(system, {{0., 0.}});
  Plates<2> &plate = system.add(std::make_unique<Plates<2>>(std::vector<Plate>{{.side = 1, .position = -0.05, .velocity = 0.5}}, 400.));
  KickDriftKick<2> integrator(system);
  system.compute_forces();
  // omega = 20 1/s: touch at t = 0.1, half a period of contact after it
  double worst = 0., deepest = 0.;
  for (int s = 0; s < 20000; ++s)
    {
      integrator.step(2e-5);
      deepest = std::max(deepest, plate.deepest());
      worst = std::max(worst, std::abs(plate.work() - system.potential_energy() - system.kinetic_energy()));
    }
  // at every moment, under load too: of m u^2/2, (omega dt)^2 and the step in which it is touched; a work that lags by half a
  // step would be off by k g u dt/2 = 1e-4
  BOOST_TEST(worst < 1e-6);
  BOOST_TEST(deepest == 0.5 / 20., boost::test_tools::tolerance(1e-5)); // u/omega
  BOOST_TEST(plate.deepest() == 0.);
  BOOST_TEST(system.particles.v[1][0] == 1., boost::test_tools::tolerance(1e-6));
  BOOST_TEST(plate.work() == system.potential_energy() + system.kinetic_energy(), boost::test_tools::tolerance(1e-6));
}

// A plate of 1 kg pressed by 2 N on a clamped particle (k = 100 N/m) swings about the depth 0.02 m with period 2 pi/10 s.
BOOST_AUTO_TEST_CASE(a_loaded_plate_swings)
{
  ParticleSystem<2> system;
  put<2>(system, {{0., 0.}});
  system.particles.inverse_mass[0] = 0.;
  Plates<2> &plates =
    system.add(std::make_unique<Plates<2>>(std::vector<Plate>{{.side = -1, .position = 0., .mass = 1., .load = -2.}}, 100.));
  KickDriftKick<2> integrator(system);
  system.compute_forces();
  const double period = 2. * std::numbers::pi / 10.;
  const int steps = 2000;
  double lowest = 0.;
  for (int s = 0; s < steps; ++s)
    {
      integrator.step(period / steps);
      lowest = std::min(lowest, plates[0].position);
    }
  // Leapfrog started with v(0) instead of v(-dt/2): off by omega dt/2 = 1.6e-3 of the amplitude.
  BOOST_CHECK_SMALL(lowest + 0.04, 0.04 * 2e-3);
  BOOST_CHECK_SMALL(plates[0].position, 0.02 * 7e-3);
}

// Plates are stepped with the fast terms: where there are no others, r-RESPA is kick-drift-kick with the substep.
BOOST_AUTO_TEST_CASE(under_respa_plates_take_the_substep)
{
  const unsigned int substeps = 5;
  const double h = 1e-3;
  const auto make = [](ParticleSystem<2> &system) -> Plates<2> & {
    put<2>(system, {{0., 0.}, {0.1, 0.01}});
    return system.add(std::make_unique<Plates<2>>(
      std::vector<Plate>{{.side = 1, .position = -0.05, .velocity = 0.5}, {.side = -1, .position = 0.02, .mass = 2., .load = -1.}}, 400.));
  };
  ParticleSystem<2> plain, split;
  const Plates<2> &a = make(plain), &b = make(split);
  KickDriftKick<2> small_steps(plain);
  Respa<2> large_steps(split, substeps);
  plain.compute_forces();
  large_steps.compute_forces();
  double most[2] = {0., 0.};
  for (int s = 0; s < 200; ++s)
    {
      for (unsigned int k = 0; k < substeps; ++k)
        small_steps.step(h);
      large_steps.step(substeps * h);
      // sums in another order: round-off
      BOOST_CHECK_SMALL(plain.particles.x[1][0] - split.particles.x[1][0], 1e-11);
      BOOST_CHECK_SMALL(plain.particles.v[1][1] - split.particles.v[1][1], 1e-9);
      BOOST_CHECK_SMALL(a[1].position - b[1].position, 1e-11);
      BOOST_CHECK_SMALL(a.work() - b.work(), 1e-9);
      for (const int k : {0, 1})
        {
          BOOST_CHECK_SMALL(a.force(k) - b.force(k), 1e-8);
          most[k] = std::max(most[k], a.force(k));
        }
    }
  BOOST_TEST(most[0] > 1.); // both have pushed
  BOOST_TEST(most[1] > 1.);
}

BOOST_AUTO_TEST_CASE(a_saved_plate_goes_on_with_the_same_bits)
{
  const auto make = [](ParticleSystem<2> &system) -> Plates<2> & {
    put<2>(system, {{0., 0.}, {0.1, 0.01}});
    return system.add(std::make_unique<Plates<2>>(
      std::vector<Plate>{{.side = 1, .position = -0.001, .velocity = 0.3}, {.side = -1, .position = 0.02, .mass = 2., .load = -1.}}, 100.));
  };
  ParticleSystem<2> whole, second;
  const Plates<2> &a = make(whole);
  Plates<2> &b = make(second);
  KickDriftKick<2> step_whole(whole), step_second(second);
  whole.compute_forces();
  for (int s = 0; s < 50; ++s)
    step_whole.step(1e-3);
  const std::string half_way = archived(whole);
  for (int s = 0; s < 50; ++s)
    step_whole.step(1e-3);
  restore(half_way, second);
  for (int s = 0; s < 50; ++s)
    step_second.step(1e-3);
  for (int d = 0; d < 2; ++d)
    BOOST_CHECK(whole.particles.x[d] == second.particles.x[d]);
  for (std::size_t k = 0; k < 2; ++k)
    BOOST_CHECK(a[k].position == b[k].position && a.force(k) == b.force(k));
  BOOST_CHECK(a.work() == b.work());
}

BOOST_AUTO_TEST_SUITE_END()
