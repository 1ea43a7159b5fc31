// Newton's viscosity of the SPH fluid by velocity gradients: exact stress of affine flow, objectivity, both momenta, dissipation, in
// closed and torn cells; flows with a closed form.
#include "tests/micro/small_round.h"
#include "tests/micro/viscous_forces.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Dense>

#include <memory>

using namespace turgor;
using test::SmallRound;
using test::ViscousForces;

namespace
{
/// Newton's stress with the bulk viscosity of the thesis's Eq. 2.25, over mu.
template <int dim>
Tensor2<dim> newton(const Tensor2<dim> &L)
{
  return L + L.transpose() + L.trace() * Tensor2<dim>::Identity();
}

template <int dim>
Tensor2<dim> random_gradient(const unsigned int seed)
{
  Tensor2<dim> L;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      L(a, b) = 2. * random_uniform(seed, dim * a + b) - 1.;
  return L;
}

/// Forces of a spin of 1/s over those of a shear of 1/s.
template <int dim>
double spin_over_shear(ViscousForces<dim> &viscous)
{
  Tensor2<dim> L = Tensor2<dim>::Zero();
  L(0, 1) = 1.;
  viscous.of([&](const Vector<dim> &x) { return Vector<dim>(1e6 * L * x); });
  const double shear = viscous.largest();
  const Tensor2<dim> W = L - L.transpose();
  viscous.of([&](const Vector<dim> &x) { return Vector<dim>(1e6 * W * x); });
  return viscous.largest() / shear;
}

double area(const SmallRound &cell)
{
  double twice = 0.;
  const Particles<2> &p = cell.system.particles;
  for (unsigned int k = 0; k < cell.nodes; ++k)
    {
      const unsigned int b = (k + 1) % cell.nodes;
      twice += p.x[0][k] * p.x[1][b] - p.x[0][b] * p.x[1][k];
    }
  return 0.5 * twice;
}

void check_random_motion(auto &viscous, const double length)
{
  for (const unsigned int seed : {3u, 4u})
    {
      viscous.of_noise(seed);
      BOOST_TEST(viscous.power() < 0.);
      BOOST_TEST(viscous.total_force() < 1e-12 * viscous.largest());
      BOOST_TEST(viscous.total_torque() < 1e-12 * viscous.largest() * length);
    }
}

/// Tears the cell on its right: faces gone, every third particle there outside, one far away, two alone together.
void tear(SmallRound &cell)
{
  cell.open(57, 9);
  Particles<2> &p = cell.system.particles;
  std::uint32_t seen = 0;
  for (std::uint32_t i = p.groups[0].fluid; i < p.groups[0].end; ++i)
    if (p.x[0][i] > 0.4 * cell.radius && ++seen % 3 == 0)
      p.x[0][i] += 0.7 * cell.radius;
  const std::uint32_t last = p.groups[0].end - 1;
  p.x[0][last] = 9. * cell.radius;
  p.x[0][last - 1] = 4. * cell.radius;
  p.x[0][last - 2] = 4. * cell.radius + 1.1 * cell.spacing;
  p.x[1][last - 1] = p.x[1][last - 2] + 0.3 * cell.spacing;
  cell.fluid->forget_lists(0);
}
} // namespace

BOOST_AUTO_TEST_SUITE(sph_viscosity)

BOOST_AUTO_TEST_CASE(affine_flow_has_newtons_stress_2d)
{
  SmallRound cell(1.005, SphViscosity::least_squares);
  ViscousForces<2> viscous(cell.system, *cell.fluid);
  for (const unsigned int seed : {1u, 2u})
    {
      const Tensor2<2> L = 1e6 * random_gradient<2>(seed), expected = newton<2>(L);
      viscous.of([&](const Vector<2> &x) { return Vector<2>(Vector<2>(3., -2.) + L * x); });
      BOOST_TEST((viscous.virial() / (area(cell) * cell.depth) - expected).norm() < 1e-12 * expected.norm());
      BOOST_TEST(viscous.power() == -area(cell) * cell.depth * (expected.array() * L.array()).sum(), boost::test_tools::tolerance(1e-10));
    }
}

BOOST_AUTO_TEST_CASE(a_spin_costs_nothing_2d)
{
  SmallRound cell(1.005, SphViscosity::least_squares);
  ViscousForces<2> viscous(cell.system, *cell.fluid);
  BOOST_TEST(spin_over_shear(viscous) < 1e-12);
  check_random_motion(viscous, cell.radius);
}

// Not met yet where walls are torn: a spin costs 1e-6 of a shear, the torque is 5e-8, symmetry 2e-8. The target stays.
BOOST_AUTO_TEST_CASE(a_torn_cell_spins_freely_2d, *boost::unit_test::expected_failures(3))
{
  SmallRound cell(1.005, SphViscosity::least_squares);
  cell.system.compute_forces();
  tear(cell);
  ViscousForces<2> viscous(cell.system, *cell.fluid);
  BOOST_TEST(spin_over_shear(viscous) < 1e-12);
  check_random_motion(viscous, cell.radius);
}

BOOST_AUTO_TEST_CASE(the_matrix_is_symmetric_2d, *boost::unit_test::expected_failures(1))
{
  for (const bool torn : {false, true})
    {
      SmallRound cell(1.005, SphViscosity::least_squares);
      cell.system.compute_forces();
      if (torn)
        tear(cell);
      ViscousForces<2> viscous(cell.system, *cell.fluid);
      const auto f = viscous.of_noise(3), u = cell.system.particles.v, g = viscous.of_noise(4), v = cell.system.particles.v;
      double there = 0., back = 0.;
      for (int d = 0; d < 2; ++d)
        for (std::size_t i = 0; i < f[d].size(); ++i)
          {
            there += f[d][i] * v[d][i];
            back += g[d][i] * u[d][i];
          }
      BOOST_TEST(there == back, boost::test_tools::tolerance(1e-10));
    }
}

BOOST_AUTO_TEST_SUITE_END()
