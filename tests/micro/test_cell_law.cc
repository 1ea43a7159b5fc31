// Laws of the parenchyma cell: wall, fluid, hinge, tie, by hand and by differences.
#include "micro/laws/equation_of_state.h"
#include "micro/laws/hydrostatic_pressure.h"
#include "micro/laws/lamella_tie.h"
#include "micro/laws/neo_hookean_wall.h"
#include "micro/laws/wall_bending.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numbers>

using namespace turgor;

namespace {
// Fifth-order accurate central difference.
template <typename Function>
double slope(const Function &f, const double x, const double h) {
  return (8. * (f(x + h) - f(x - h)) - (f(x + 2. * h) - f(x - 2. * h))) / (12. * h);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(cell_law)

BOOST_AUTO_TEST_CASE(wall_by_hand) {
  // As written in Eqs. 3.4 and 3.5 (corrected), term by term.
  for (const double beta : {0., 0.25, 0.5, 0.9})
    for (const double lambda : {0.4, 0.9, 1., 1.02, 1.5, 3.}) {
      const NeoHookeanWall wall(100., 50e-6, beta);
      const double alpha_squared =
          0.5 * (beta + std::sqrt(beta * beta - 4. * (beta - 1.) / std::pow(lambda, 6)));
      const double expected = 100. * 50e-6 * (lambda - 1. / (alpha_squared * std::pow(lambda, 5)));
      BOOST_TEST(std::abs(wall.force(lambda) - expected) <= 1e-14 * (std::abs(expected) + 5e-3));
    }
  // cube: alpha = 1
  const NeoHookeanWall cube(100., 50e-6, 1.);
  BOOST_TEST(cube.force(1.3) == 5e-3 * (1.3 - std::pow(1.3, -5)), boost::test_tools::tolerance(1e-14));
  // small strain: 6/(2 - beta), i.e. E = 4 G for beta = 1/2
  BOOST_TEST(NeoHookeanWall(100., 50e-6, 0.5).derivative(1.) == 4. * 5e-3,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(wall_stretch_at_turgor) {
  // errata, closed forms: 2 F/(L z0) = 200 kPa with L = 100 um, z0 = 50 um, G t0 = 100 N/m
  const NeoHookeanWall wall(100., 50e-6, 0.5);
  const double lambda_0 = wall.stretch_at(0.5 * 200e3 * 100e-6 * 50e-6);
  BOOST_TEST(std::abs(lambda_0 - 1.02575) < 5e-6);
  BOOST_TEST(2. * wall.force(lambda_0) / (100e-6 * 50e-6) == 200e3, boost::test_tools::tolerance(1e-13));
  for (const double tension : {-1., -1e-3, 0., 1e-3, 1.})
    BOOST_TEST(std::abs(wall.force(wall.stretch_at(tension)) - tension) < 1e-13 * (1. + std::abs(tension)));
}

BOOST_AUTO_TEST_CASE(wall_energy_is_consistent) {
  for (const double beta : {0., 0.5, 1.}) {
    const NeoHookeanWall wall(100., 50e-6, beta);
    BOOST_TEST(wall.energy(1.) == 0.);
    const auto energy = [&](const double l) { return wall.energy(l); };
    const auto force = [&](const double l) { return wall.force(l); };
    for (double lambda = 0.02; lambda < 60.; lambda *= 1.0371) {
      const double h = 5e-4 * lambda, F = wall.force(lambda);
      // scale: the energy's own round-off over the step, and the force
      const double allowed = 1e-10 * (std::abs(F) + 5e-3) + 1e-15 * wall.energy(lambda) / h;
      BOOST_TEST(std::abs(slope(energy, lambda, h) - F) < allowed,
                 "lambda " << lambda << " beta " << beta << ": " << slope(energy, lambda, h) - F);
      double both;
      wall.force(lambda, both);
      BOOST_TEST(both == wall.derivative(lambda));
      BOOST_TEST(std::abs(slope(force, lambda, h) - wall.derivative(lambda)) < 1e-9 * std::abs(both));
    }
  }
  // beta = 1 has the closed form lambda^2/2 + lambda^-4/4 - 3/4
  const NeoHookeanWall cube(2., 1., 1.);
  for (const double l : {0.03, 0.3, 0.97, 1.4, 30.})
    BOOST_TEST(cube.energy(l) == 2. * (0.5 * l * l + 0.25 * std::pow(l, -4) - 0.75),
               boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(many_edges_at_once_give_the_same_bits) {
  std::vector<double> lambda = {0., -1., 1.};
  for (double at = 0.02; at < 60.; at *= 1.013) lambda.push_back(at);
  for (const WallYield &yield : {WallYield(), WallYield{15., 0.9}}) {
    const NeoHookeanWall wall(100., 50e-6, 0.5, yield);
    std::vector<double> energy(lambda.size()), force(lambda.size()), slope(lambda.size());
    wall.energies(lambda.size(), lambda.data(), energy.data());
    wall.forces(lambda.size(), lambda.data(), force.data(), slope.data());
    for (std::size_t i = 0; i < lambda.size(); ++i) {
      BOOST_TEST(energy[i] == wall.energy(lambda[i]));
      double alone = 0.;
      BOOST_TEST((lambda[i] == 0. || (force[i] == wall.force(lambda[i], alone) && slope[i] == alone)));
    }
  }
}

BOOST_AUTO_TEST_CASE(fluid_by_hand) {
  const EquationOfState fluid(1000., 6e6, -100e3);
  BOOST_TEST(fluid.pressure(1000.) == 0.);
  BOOST_TEST(fluid.sound_speed(1000.) == std::sqrt(7. * 6e6 / 1000.), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(fluid.pressure(1010.) == 6e6 * (std::pow(1.01, 7) - 1.), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(fluid.density_at(200e3) < 1010.);  // turgor costs at most 1 % of density
  for (const double p : {-400e3, -100e3, -99e3, 0., 200e3, 1e7})
    BOOST_TEST(std::abs(fluid.pressure(fluid.density_at(p)) - p) < 1e-6);
  // 1 % of the liquid's slope beyond the cavitation pressure, continuous pressure
  const double rho_c = fluid.cavitation_density();
  BOOST_TEST(std::abs(fluid.pressure(rho_c) + 100e3) < 1e-6);
  BOOST_TEST(std::abs(fluid.pressure(rho_c * (1. - 1e-12)) + 100e3) < 1e-3);
  BOOST_TEST(fluid.slope(0.99 * rho_c) == 0.01 * fluid.slope(rho_c), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(fluid_energy_is_consistent) {
  const EquationOfState fluid(1000., 6e6, -100e3);
  const auto energy = [&](const double r) { return fluid.energy(r); };
  BOOST_TEST(fluid.energy(1000.) == 0.);
  for (double rho = 100.; rho < 1500.; rho += 7.3) {
    const double h = std::min(0.02, 0.4 * std::abs(rho - fluid.cavitation_density()));
    const double expected = fluid.pressure(rho) / (rho * rho);
    BOOST_TEST(std::abs(slope(energy, rho, h) - expected) < 1e-9 * std::abs(expected) + 1e-9);
  }
  const HydrostaticPressure cell{fluid};
  const double mass = 5e-10, V = 4.99e-13;
  const auto of_volume = [&](const double v) { return cell.energy(mass, v); };
  const auto pressure = [&](const double v) { return cell.pressure(mass, v); };
  BOOST_TEST(-slope(of_volume, V, 1e-4 * V) == cell.pressure(mass, V), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(-slope(pressure, V, 1e-4 * V) == cell.stiffness(mass, V), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(hinge_angle) {
  // sign and value by hand: a left turn of 90 degrees
  BOOST_TEST(WallBending::angle({2., 0.}, {0., 3.}) == std::numbers::pi / 2.);
  BOOST_TEST(WallBending::angle({2., 0.}, {0., -3.}) == -std::numbers::pi / 2.);
  // the series of nearly flat hinges is atan2
  for (double t = -0.2; t < 0.2; t += 0.00731)
    BOOST_TEST(std::abs(WallBending::angle({2., 0.}, {3. * std::cos(t), 3. * std::sin(t)}) - t) <
               1e-16 + 2e-16 * std::abs(t));
  // curvature of the direction angle
  const Vector<2> v(0.7, -0.4);
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d) {
      const double numeric = slope(
          [&](const double s) {
            Vector<2> w = v;
            w[d] += s;
            return WallBending::angle_gradient(w)[c];
          },
          0., 1e-3);
      BOOST_TEST(std::abs(numeric - WallBending::angle_hessian(v)(c, d)) < 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(tie_force) {
  const LamellaSpring tie{2.};
  Tensor2<2> H;
  H << 3., 0.5, 0., 2.;
  const Vector<2> d = LamellaSpring::gap({0.1, 0.2}, {-2.8, 0.1}, {{1, 0}}, H);
  BOOST_TEST((d - Vector<2>(0.1, -0.1)).norm() < 1e-15);
  BOOST_TEST((tie.force_on_a(d) - Vector<2>(0.2, -0.2)).norm() < 1e-15);
  BOOST_TEST(tie.energy(d) == 0.02, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
