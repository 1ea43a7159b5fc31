// The kernel of fourth order: what its density shows of it, moments, transform; one energy; a long wave's
// density to fourth order; the bound of its stiffest mode.
#include "micro/processes/bring_to_turgor.h"
#include "micro/geometry/geodesic_sphere.h"
#include "micro/cells/round_cell.h"
#include "tests/micro/slope_of_energy.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numeric>
#include <tuple>

using namespace turgor;

namespace {
RoundCellParameters round_cell(const std::string &kernel) {
  RoundCellParameters p;
  p.fourth_order = kernel == "fourth_order";
  p.ring_nodes = 40;
  p.frequency = 4;
  p.fluid_particles = 200;
  p.turgor = 0.;
  return p;
}

using Dimensions = std::tuple<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

/// W over its peak at r = k/n supports, from the densities of two particles in the middle of a cell.
template <int dim>
std::vector<double> kernel_values(const bool fourth_order, const int n) {
  const double R = 1e-6, reach = 20. * R;
  SphFluidParameters fluid;
  fluid.support = R;
  fluid.skin = 0.1 * R;
  fluid.depth = 1e-6;
  fluid.exact_volume = false;
  fluid.fourth_order = fourth_order;
  const EquationOfState eos(1000., 6e6, -100e3);
  std::vector<Vector<dim>> nodes;
  ParticleSystem<dim> system;
  std::unique_ptr<SphFluid<dim>> made;
  if constexpr (dim == 3) {
    GeodesicSphere sphere = make_geodesic_sphere(3);
    nodes.assign(sphere.positions.begin(), sphere.positions.end());
    made = std::make_unique<SphFluid<3>>(fluid, eos, std::vector<double>(1, 1e-15),
                                         std::make_shared<const TriangleMesh>(std::move(sphere.mesh)));
  } else {
    for (int k = 0; k < 24; ++k) nodes.push_back({std::cos(M_PI * k / 12.), std::sin(M_PI * k / 12.)});
    made = std::make_unique<SphFluid<2>>(fluid, eos, std::vector<double>(1, 1e-15));
  }
  Particles<dim> &p = system.particles;
  const std::uint32_t nw = std::uint32_t(nodes.size());
  p.resize(nw + 2);
  p.groups = {Group{0, nw, nw + 2}};
  for (std::uint32_t i = 0; i < nw; ++i)
    for (int d = 0; d < dim; ++d) p.x[d][i] = reach * nodes[i][d];
  system.add(std::move(made));
  std::vector<double> values;
  double alone = 0.;
  for (int k = n + 1; k >= 0; --k) {
    p.x[0][nw + 1] = k * R / n;  // not exactly at 0: a particle is no neighbour of itself
    system.compute_forces();
    const double rho = p.field("density")[nw];
    if (k == n + 1)
      alone = rho;
    else
      values.insert(values.begin(), rho / alone - 1.);
  }
  return values;
}

/// integral of u^power f(u) du over [0, 1], by Simpson's rule; f at k/n.
double integral(const std::vector<double> &f, const auto &weight) {
  const int n = int(f.size()) - 1;
  double sum = 0.;
  for (int k = 0; k <= n; ++k)
    sum += (k == 0 || k == n ? 1. : k % 2 ? 4. : 2.) * f[k] * weight(double(k) / n) / (3. * n);
  return sum;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(sph_kernels)

BOOST_AUTO_TEST_CASE_TEMPLATE(fourth_order_has_no_second_moment_and_a_positive_transform, Dim, Dimensions) {
  constexpr int dim = Dim::value;
  const int n = 400;
  const std::vector<double> ordinary = kernel_values<dim>(false, n), fourth = kernel_values<dim>(true, n);
  const auto moment = [&](const std::vector<double> &f, const int power) {
    return integral(f, [&](const double u) { return std::pow(u, power + dim - 1); });
  };
  BOOST_TEST(std::abs(moment(ordinary, 2) / moment(ordinary, 0) - (dim == 2 ? 5. / 36. : 1. / 5.)) < 1e-6);
  BOOST_TEST(std::abs(moment(fourth, 2) / moment(fourth, 0)) < 1e-6);
  // Its peak is alpha times as high: both integrals are 1.
  BOOST_TEST(std::abs(moment(ordinary, 0) / moment(fourth, 0) - (dim == 2 ? 504. / 229. : 50. / 17.)) < 1e-5);
  BOOST_TEST(*std::min_element(fourth.begin(), fourth.end()) < -0.01);  // the ring
  double least = 1., stiffest[2] = {0., 0.};
  for (double k = 0.25; k < 60.; k += 0.25) {
    const auto wave = [&](const double u) {
      return dim == 2 ? u * std::cyl_bessel_j(0., k * u) : u * std::sin(k * u) / k;
    };
    const double hat[2] = {integral(ordinary, wave) / moment(ordinary, 0),
                           integral(fourth, wave) / moment(fourth, 0)};
    least = std::min(least, hat[1]);
    for (int m = 0; m < 2; ++m) stiffest[m] = std::max(stiffest[m], k * hat[m]);
    if (k < 1.) BOOST_TEST(std::abs(hat[1] - 1.) < 1e-3 * k * k * k * k);
  }
  BOOST_TEST_MESSAGE("least of the transform " << least << ", largest k W^: " << stiffest[0] << " and "
                                               << stiffest[1]);
  BOOST_TEST(least > -1e-7);
  BOOST_TEST(stiffest[1] / stiffest[0] < 12. / 6.5);  // as SphFluid::rates has it
}

BOOST_AUTO_TEST_CASE_TEMPLATE(one_energy_and_momentum, Dim, Dimensions) {
  constexpr int dim = Dim::value;
  const auto cell = make_round_cell<dim>(round_cell("fourth_order"), false);
  ParticleSystem<dim> &system = cell->system;
  const double spacing = cell->sph->support() / cell->parameters.support_ratio;
  const double error = test::slope_error(system, 1e-5 * spacing, 7);
  BOOST_TEST_MESSAGE("F = -dE/dx: " << error);
  BOOST_TEST(error < 1e-6);
  const double scale = test::largest_component(system.particles) * std::sqrt(double(system.particles.size()));
  for (int d = 0; d < dim; ++d)
    BOOST_TEST(std::abs(std::accumulate(system.particles.f[d].begin(), system.particles.f[d].end(), 0.)) <
               1e-13 * scale);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_bound_holds_for_the_stiffest_mode, Dim, Dimensions) {
  constexpr int dim = Dim::value;
  for (const std::string kernel : {"wendland", "fourth_order"}) {
    RoundCellParameters parameters = round_cell(kernel);
    parameters.settle_steps = 300;
    const auto cell = make_round_cell<dim>(parameters, false);
    settle_fluid<dim>(*cell, {});
    cell->system.compute_forces();
    const Group &g = cell->group();
    const double spacing = cell->sph->support() / parameters.support_ratio;
    const double mode = test::highest_frequency_squared(cell->system, g.fluid, g.end, 1e-4 * spacing, 30),
                 bound = cell->sph->rates(cell->system.particles).fluid.frequency_squared;
    BOOST_TEST_MESSAGE(kernel << ": bound over measured frequency " << std::sqrt(bound / mode));
    BOOST_TEST(mode < bound);
  }
}

BOOST_AUTO_TEST_CASE(walls_that_fail_are_refused) {
  BOOST_CHECK_THROW(make_round_cell<3>(round_cell("fourth_order"), true), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
