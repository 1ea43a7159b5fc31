// Water through the cell wall: the approach to turgor in closed form, its fixed point, and how a cell
// shares out what it takes in.
#include "micro/processes/osmosis.h"
#include "tests/micro/small_patch.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;

BOOST_FIXTURE_TEST_SUITE(osmosis, test::SmallPatch)

BOOST_AUTO_TEST_CASE(pressure_approaches_turgor_as_its_closed_form) {
  // Particles that do not move and all have one density rho: rho is proportional to the cell's water m, and
  // with Eq. 2.22, P + K = K (rho/rho_0)^7, the law (1/m) dm/dt = r (T - P)/(7 K) becomes, for y = 1 + P/K
  // and z = 1 + T/K,
  //   dy/dt = r y (z - y),   y(t) = z / (1 + (z/y_0 - 1) exp(-r z t))
  // The process takes explicit Euler steps, so the error is of first order in dt.
  sph.formulation = SphFormulation::thesis;  // its density follows the water alone while nothing moves
  const double K = cell.fluid_modulus, rate = 1e5, span = 1.5 / rate;
  for (const double target : {1.5 * cell.turgor, 0.3 * cell.turgor, 5. * K}) {
    double error[2];
    for (const int refine : {0, 1}) {
      auto patch = lattice();
      patch->system.compute_forces();
      const Osmosis process(target, rate, 7. * K);
      const double start = patch->fluid->mean_pressure(patch->system.particles, 0);
      BOOST_TEST(start == cell.turgor, boost::test_tools::tolerance(1e-10));
      const int steps = 200 << refine;
      for (int s = 0; s < steps; ++s) {
        process.apply(patch->system, *patch->fluid, span / steps);
        patch->system.compute_forces();
      }
      const double y = 1. + start / K, z = 1. + target / K;
      const double exact = K * (z / (1. + (z / y - 1.) * std::exp(-rate * z * span)) - 1.);
      error[refine] = std::abs(patch->fluid->mean_pressure(patch->system.particles, 0) - exact) /
                      std::abs(target - start);
    }
    BOOST_TEST_MESSAGE("target " << target << " Pa: relative errors " << error[0] << " " << error[1]);
    BOOST_TEST(std::log2(error[0] / error[1]) > 0.95);
  }
}

BOOST_AUTO_TEST_CASE(at_its_target_no_water_flows_and_above_it_water_leaves) {
  auto patch = disturbed(1, 1);
  patch->system.compute_forces();
  const double pressure = patch->fluid->mean_pressure(patch->system.particles, 0);
  const double mass = patch->fluid->particle_mass()[0];
  Osmosis(pressure, 1e5, 7. * cell.fluid_modulus).apply(patch->system, *patch->fluid, 1e-7);
  BOOST_TEST(patch->fluid->particle_mass()[0] == mass);
  Osmosis(pressure - 1e3, 1e5, 7. * cell.fluid_modulus).apply(patch->system, *patch->fluid, 1e-7);
  BOOST_TEST(patch->fluid->particle_mass()[0] < mass);
}

BOOST_AUTO_TEST_CASE(a_cell_shares_its_water_evenly_among_its_particles) {
  const double rate = 1e5, dt = 1e-7, bulk_modulus = 7. * cell.fluid_modulus, target = 2. * cell.turgor;
  for (const char *formulation : {"variational", "thesis"}) {
    sph.formulation = choice_of<SphFormulation>(formulation);
    auto patch = disturbed(2, 1);
    ParticleSystem<2> &system = patch->system;
    // cells at different pressures
    patch->fluid->set_particle_mass(system.particles, 1, 1.01 * patch->fluid->particle_mass()[1]);
    system.compute_forces();
    const Particles<2> before = system.particles;
    double gain[2];
    for (int c = 0; c < 2; ++c)
      gain[c] = rate * dt * (target - patch->fluid->mean_pressure(before, c)) / bulk_modulus;
    BOOST_TEST(gain[0] > gain[1]);  // the emptier cell drinks more
    Osmosis(target, rate, bulk_modulus).apply(system, *patch->fluid, dt);
    for (std::size_t c = 0; c < 2; ++c) {
      const Group &g = system.particles.groups[c];
      double water[2]{};
      for (std::uint32_t i = g.begin; i < g.end; ++i) {
        const double old_mass = 1. / before.inverse_mass[i], new_mass = 1. / system.particles.inverse_mass[i];
        if (i < g.fluid)
          BOOST_TEST(new_mass == old_mass);  // walls take no water
        else
          BOOST_TEST(new_mass == 1. / system.particles.inverse_mass[g.fluid]);
        water[0] += i < g.fluid ? 0. : old_mass;
        water[1] += i < g.fluid ? 0. : new_mass;
      }
      BOOST_TEST(water[1] / water[0] - 1. == gain[c], boost::test_tools::tolerance(1e-9));
    }
    BOOST_TEST((system.particles.x == before.x));
    BOOST_TEST((system.particles.v == before.v));
  }
}

BOOST_AUTO_TEST_SUITE_END()
