// Newton's viscosity of the SPH fluid by velocity gradients: exact stress of affine flow, objectivity, both
// momenta, dissipation, in closed and torn cells, 2D and 3D.
#include "tests/micro/small_round.h"
#include "tests/micro/small_sphere.h"
#include "tests/micro/viscous_forces.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using test::SmallRound;
using test::SmallSphere;
using test::ViscousForces;

namespace {
/// Newton's stress with the bulk viscosity of the thesis's Eq. 2.25, over mu.
template <int dim>
Tensor2<dim> newton(const Tensor2<dim> &L) {
  return L + L.transpose() + L.trace() * Tensor2<dim>::Identity();
}

template <int dim>
Tensor2<dim> random_gradient(const unsigned int seed) {
  Tensor2<dim> L;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) L(a, b) = 2. * random_uniform(seed, dim * a + b) - 1.;
  return L;
}

/// Forces of a spin of 1/s over those of a shear of 1/s.
template <int dim>
double spin_over_shear(ViscousForces<dim> &viscous) {
  Tensor2<dim> L = Tensor2<dim>::Zero();
  L(0, 1) = 1.;
  viscous.of([&](const Vector<dim> &x) { return Vector<dim>(1e6 * L * x); });
  const double shear = viscous.largest();
  const Tensor2<dim> W = L - L.transpose();
  viscous.of([&](const Vector<dim> &x) { return Vector<dim>(1e6 * W * x); });
  return viscous.largest() / shear;
}

double volume(const SmallRound &cell) {
  double twice = 0.;
  const Particles<2> &p = cell.system.particles;
  for (unsigned int k = 0; k < cell.nodes; ++k) {
    const unsigned int b = (k + 1) % cell.nodes;
    twice += p.x[0][k] * p.x[1][b] - p.x[0][b] * p.x[1][k];
  }
  return 0.5 * twice * cell.depth;
}

double volume(const SmallSphere::Cell &cell) {
  const Particles<3> &p = cell.system.particles;
  return cell.mesh->volume(p.x[0].data(), p.x[1].data(), p.x[2].data());
}

template <int dim>
void check_affine_stress(ParticleSystem<dim> &system, SphFluid<dim> &fluid, const double volume) {
  ViscousForces<dim> viscous(system, fluid);
  for (const unsigned int seed : {1u, 2u}) {
    const Tensor2<dim> L = 1e6 * random_gradient<dim>(seed), expected = newton<dim>(L);
    viscous.of([&](const Vector<dim> &x) { return Vector<dim>(3. * Vector<dim>::Ones() + L * x); });
    BOOST_TEST((viscous.virial() / volume - expected).norm() < 1e-12 * expected.norm());
    BOOST_TEST(viscous.power() == -volume * (expected.array() * L.array()).sum(),
               boost::test_tools::tolerance(1e-10));
  }
}

void check_random_motion(auto &viscous, const double length) {
  for (const unsigned int seed : {3u, 4u}) {
    viscous.of_noise(seed);
    BOOST_TEST(viscous.power() < 0.);
    BOOST_TEST(viscous.total_force() < 1e-12 * viscous.largest());
    BOOST_TEST(viscous.total_torque() < 1e-12 * viscous.largest() * length);
  }
}

/// Tears the cell on its right: faces gone, every third particle there outside, one far away, two alone
/// together.
void tear(SmallRound &cell) {
  cell.open(57, 9);
  Particles<2> &p = cell.system.particles;
  std::uint32_t seen = 0;
  for (std::uint32_t i = p.groups[0].fluid; i < p.groups[0].end; ++i)
    if (p.x[0][i] > 0.4 * cell.radius && ++seen % 3 == 0) p.x[0][i] += 0.7 * cell.radius;
  const std::uint32_t last = p.groups[0].end - 1;
  p.x[0][last] = 9. * cell.radius;
  p.x[0][last - 1] = 4. * cell.radius;
  p.x[0][last - 2] = 4. * cell.radius + 1.1 * cell.spacing;
  p.x[1][last - 1] = p.x[1][last - 2] + 0.3 * cell.spacing;
  cell.fluid->forget_lists(0);
}

/// The same on a sphere's top, with three in a line far away.
void tear(SmallSphere::Cell &cell, const double radius) {
  SmallSphere::open(cell, 0.7);
  Particles<3> &p = cell.system.particles;
  std::uint32_t seen = 0;
  for (std::uint32_t i = p.groups[0].fluid; i < p.groups[0].end; ++i)
    if (p.x[2][i] > 0.4 * radius && ++seen % 3 == 0) p.x[2][i] += 0.7 * radius;
  const std::uint32_t last = p.groups[0].end - 1;
  p.x[2][last] = 9. * radius;
  for (std::uint32_t k = 1; k <= 3; ++k) {
    p.x[0][last - k] = 4. * radius + 1.1 * k * cell.spacing;
    p.x[1][last - k] = p.x[2][last - k] = 1e-7 * k * cell.spacing;
  }
  cell.fluid->forget_lists(0);
}

/// A force in motion u does the same work in motion v as the other way round.
template <int dim>
void check_symmetry(ParticleSystem<dim> &system, SphFluid<dim> &fluid) {
  ViscousForces<dim> viscous(system, fluid);
  const auto f = viscous.of_noise(3), u = system.particles.v, g = viscous.of_noise(4), v = system.particles.v;
  double there = 0., back = 0.;
  for (int d = 0; d < dim; ++d)
    for (std::size_t i = 0; i < f[d].size(); ++i) {
      there += f[d][i] * v[d][i];
      back += g[d][i] * u[d][i];
    }
  BOOST_TEST(there == back, boost::test_tools::tolerance(1e-10));
}

/// Objective, symmetric, of both momenta: whole or torn.
template <int dim>
void check_all(ParticleSystem<dim> &system, SphFluid<dim> &fluid, const double length) {
  ViscousForces<dim> viscous(system, fluid);
  const double spin = spin_over_shear(viscous);
  BOOST_TEST_MESSAGE("largest force of a spin over a shear's " << spin);
  BOOST_TEST(spin < 1e-12);
  check_random_motion(viscous, length);
  check_symmetry(system, fluid);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(sph_viscosity)

BOOST_AUTO_TEST_CASE(affine_flow_has_newtons_stress_2d) {
  SmallRound cell;
  check_affine_stress(cell.system, *cell.fluid, volume(cell));
}

BOOST_FIXTURE_TEST_CASE(affine_flow_has_newtons_stress_3d, SmallSphere) {
  const auto cell = make();
  check_affine_stress(cell->system, *cell->fluid, volume(*cell));
}

BOOST_AUTO_TEST_CASE(a_spin_costs_nothing_and_momenta_are_kept_2d) {
  SmallRound cell;
  check_all(cell.system, *cell.fluid, cell.radius);
}

BOOST_FIXTURE_TEST_CASE(a_spin_costs_nothing_and_momenta_are_kept_3d, SmallSphere) {
  const auto cell = make();
  check_all(cell->system, *cell->fluid, radius);
}

BOOST_AUTO_TEST_CASE(also_in_a_torn_cell_2d) {
  SmallRound cell;
  cell.system.compute_forces();
  tear(cell);
  check_all(cell.system, *cell.fluid, cell.radius);
}

BOOST_FIXTURE_TEST_CASE(also_in_a_torn_cell_3d, SmallSphere) {
  damaged = true;
  const auto cell = make();
  cell->system.compute_forces();
  tear(*cell, radius);
  check_all(cell->system, *cell->fluid, radius);
}

// What has no neighbours for a gradient still has a viscosity: two particles alone that part are held back,
// central, as Monaghan's drag has it.
BOOST_AUTO_TEST_CASE(two_particles_alone_resist_each_other) {
  SmallRound cell;
  cell.system.compute_forces();
  tear(cell);
  Particles<2> &p = cell.system.particles;
  const std::uint32_t b = p.groups[0].end - 2, a = b - 1, first = p.groups[0].begin;
  ViscousForces<2> viscous(cell.system, *cell.fluid);
  const Vector<2> apart = p.position(b) - p.position(a);
  for (auto &v : p.v) std::fill(v.begin(), v.end(), 0.);
  for (int d = 0; d < 2; ++d) p.v[d][b] = apart[d] / apart.norm();
  viscous.of_velocities();
  const double volume = 1.005 * std::numbers::pi * cell.radius * cell.radius * cell.depth /
                        p.groups[0].fluid_count(),
               R = 2.6 * cell.spacing;
  const double slope =
      140. / (std::numbers::pi * std::pow(R, 4)) * std::pow(1. - apart.norm() / R, 3) / cell.depth;  // |W'|/r
  const double expected = 2. * 4. * volume * volume * slope;  // 2 (d + 2) mu V^2 |W'|/r v
  BOOST_TEST((viscous.force(b - first) + expected * apart / apart.norm()).norm() < 1e-10 * expected);
  BOOST_TEST((viscous.force(a - first) - expected * apart / apart.norm()).norm() < 1e-10 * expected);
}

// From water, one evaluation of the forces, to 1e3 Pa s, dozens: t times the fastest rate is 1e-3 to 1e3.
BOOST_AUTO_TEST_CASE(impulses_keep_both_momenta_and_take_energy_at_any_viscosity) {
  for (const double mu : {1e-3, 1., 1e3}) {
    SmallRound cell;
    Particles<2> &p = cell.system.particles;
    ViscousForces<2> viscous(cell.system, *cell.fluid, mu);
    viscous.of_noise(5);
    const auto moments = [&] {
      Vector<3> sum = Vector<3>::Zero();
      for (std::size_t i = 0; i < p.size(); ++i) {
        const Vector<2> v(p.v[0][i], p.v[1][i]), x = p.position(i);
        sum += Vector<3>(v[0], v[1], (x[0] * v[1] - x[1] * v[0]) / cell.radius) / p.inverse_mass[i];
      }
      return sum;
    };
    const Vector<3> before = moments();
    const double energy = cell.system.kinetic_energy(), power = viscous.power(), dt = 1e-9,
                 size = 1. / p.inverse_mass[0] * double(p.size());
    cell.fluid->damp(p, cell.system.box, 0, dt);
    BOOST_TEST((moments() - before).norm() < 1e-12 * size);
    const double lost = energy - cell.system.kinetic_energy();
    BOOST_TEST_MESSAGE(mu << " Pa s: loses " << lost / energy << " of the energy");
    BOOST_TEST(lost > 0.);
    BOOST_TEST(lost < energy);
    BOOST_TEST(std::abs(cell.system.heat() - lost) < 1e-12 * energy);  // and that is what it tells
    if (mu == 1e-3) BOOST_TEST(lost == -power * dt, boost::test_tools::tolerance(1e-2));
    // its virial is that of the mean force
    const Tensor2<2> virial = cell.fluid->damping_virial(p, 0);
    BOOST_TEST((virial - virial.transpose()).norm() < 1e-10 * virial.norm());
  }
}

// Drawn out, where modes are faster than the bound for a cell as it was laid out: the polynomial of the
// bound's degree may feed them, and drag must not. The fastest rate by power iteration.
BOOST_AUTO_TEST_CASE(impulses_only_take_energy_from_a_cell_that_is_drawn_out) {
  for (const double stretch : {1., 3., 6.}) {
    SmallRound cell;
    Particles<2> &p = cell.system.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.x[0][i] *= stretch;
      p.x[1][i] /= stretch;
    }
    cell.system.compute_forces();
    ViscousForces<2> viscous(cell.system, *cell.fluid, 1.);
    viscous.of_noise(5);
    double fastest = 0.;
    for (int k = 0; k < 300; ++k) {
      const auto f = viscous.of_velocities();
      double size = 0., next = 0.;
      for (int d = 0; d < 2; ++d)
        for (std::size_t i = 0; i < p.size(); ++i) {
          size += p.v[d][i] * p.v[d][i] / p.inverse_mass[i];
          p.v[d][i] = f[d][i] * p.inverse_mass[i];
          next += p.v[d][i] * p.v[d][i] / p.inverse_mass[i];
        }
      fastest = std::sqrt(next / size);
      for (auto &component : p.v)
        for (double &v : component) v /= std::sqrt(next);
    }
    BOOST_TEST_MESSAGE("stretch " << stretch << ": fastest rate over its bound "
                                  << fastest / cell.fluid->damping_bound(p, 0));
    for (int k = 0; k < 40; ++k)  // of the fastest mode alone
    {
      const double energy = cell.system.kinetic_energy();
      cell.fluid->damp(p, cell.system.box, 0, 6. / cell.fluid->damping_bound(p, 0));
      BOOST_TEST(cell.system.kinetic_energy() <= energy * (1. + 1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_cell_that_has_flown_apart_ends_its_step) {
  SphImpulses<2> impulses;
  impulses.waited = 1.;
  for (const auto &[rate, degree] :
       {std::pair{1e-3, 1}, std::pair{2., 1}, std::pair{6., 2}, std::pair{1e30, 1000},
        std::pair{HUGE_VAL, 1000}, std::pair{double(NAN), 1000}})
    BOOST_TEST(impulses.degree(rate) == degree);
}

BOOST_AUTO_TEST_SUITE_END()
