// Both ways of solving a tangent's system give the same answer; what the rigid-body modes are worth.
#include "tests/macro/tissue_fixture.h"

#include "macro/rigid_body_modes.h"
#include "macro/static_balance.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(linear_solver)

namespace {
template <int dim>
TissueParameters<dim> block(const unsigned int elements) {
  TissueParameters<dim> p;
  p.size.fill(width);
  p.elements.fill(elements);
  p.body_force[1] = -1e3;
  return p;
}

struct Solved {
  std::vector<double> x;
  LinearStatistics statistics;
};

template <int dim>
Solved solve(const TissueParameters<dim> &p, const LinearSettings &settings, const double skew = 0.) {
  NeoHookeanLaw<dim> law(mu, 3. * mu, 0., rho);
  TissueMesh<dim> mesh(p);
  TissueOperator<dim> op(mesh, p, law);
  op.evaluate(0., 0., wavy(mesh, 0.01 * width, 0.2), std::vector<double>(op.size(), 0.), true);
  std::vector<double> element, right(op.size());
  op.element_stiffness(element);
  // some of each element's lower half, not of its upper one
  const std::size_t n = mesh.nodes_per_cell * dim;
  for (std::size_t k = 0; k < element.size(); ++k)
    if (k / n % n > k % n) element[k] *= 1. + skew;
  for (std::size_t i = 0; i < right.size(); ++i) right[i] = op.fixed(i) ? 0. : op.external_forces()[i];
  LinearSolver<dim> solver(mesh, settings);
  solver.set_matrix(element, {}, skew == 0.);
  return {solver.solve(right), solver.statistics()};
}

double difference(const std::vector<double> &a, const std::vector<double> &b) {
  double most = 0., size = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return most / size;
}

template <int dim>
void compare(const unsigned int elements, const double skew) {
  LinearSettings direct, multigrid;
  direct.method = LinearMethod::direct;
  multigrid.method = LinearMethod::multigrid;
  const TissueParameters<dim> p = block<dim>(elements);
  const Solved a = solve<dim>(p, direct, skew), b = solve<dim>(p, multigrid, skew);
  BOOST_TEST_MESSAGE(dim << "D, skew " << skew << ": " << b.statistics.iterations << " iterations, off by "
                         << difference(b.x, a.x));
  BOOST_TEST(b.statistics.by_multigrid == 1u);
  BOOST_TEST(b.statistics.fallbacks == 0u);
  BOOST_TEST(difference(b.x, a.x) < 1e-7);
}
}  // namespace

BOOST_AUTO_TEST_CASE(multigrid_and_direct_give_the_same) {
  for (const double skew : {0., 0.02}) {
    compare<2>(48, skew);
    compare<3>(11, skew);
  }
}

// Iterations hardly grow with the mesh, and translations alone need more of them.
BOOST_AUTO_TEST_CASE(rigid_body_modes_keep_the_iterations_down) {
  LinearSettings with, without;
  with.method = without.method = LinearMethod::multigrid;
  without.rigid_body_modes = false;
  const auto coarse = solve<2>(block<2>(40), with), fine = solve<2>(block<2>(120), with),
             poor = solve<2>(block<2>(120), without);
  BOOST_TEST_MESSAGE("40 x 40: " << coarse.statistics.iterations
                                 << ", 120 x 120: " << fine.statistics.iterations
                                 << ", translations only: " << poor.statistics.iterations);
  BOOST_TEST(fine.statistics.iterations < 2 * coarse.statistics.iterations);
  BOOST_TEST(poor.statistics.iterations > fine.statistics.iterations);
}

BOOST_AUTO_TEST_CASE(modes_are_without_energy) {
  TissueParameters<2> p = block<2>(3);
  p.left = LeftSide::plate;
  NeoHookeanLaw<2> law(mu, 3. * mu, 0., rho);
  TissueMesh<2> mesh(p);
  TissueOperator<2> op(mesh, p, law);
  const std::vector<double> modes = rigid_body_modes(mesh);
  BOOST_REQUIRE(modes.size() == 3 * op.size());
  for (int m = 0; m < 3; ++m) {
    std::vector<double> u(modes.begin() + m * std::ptrdiff_t(op.size()),
                          modes.begin() + (m + 1) * std::ptrdiff_t(op.size())),
        force;
    for (double &x : u) x *= 1e-6 * width;
    BOOST_REQUIRE(op.evaluate(0., 0., u, std::vector<double>(op.size(), 0.)));
    op.internal_forces(force);
    for (const double f : force) BOOST_TEST(std::abs(f) < 1e-9 * mu * width);  // of second order
  }
}

BOOST_AUTO_TEST_SUITE_END()
