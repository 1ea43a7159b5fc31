// Terms of deformable cells: slopes of energies, net forces and torques, what rigid motions rub, what
// implicit steps see, springs by hand.
#include "cortex_cell.h"
#include "micro/solve/motion_matrix.h"
#include "slope_of_energy.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;
using Cell = test::CortexCell;

namespace {
/// Slope of the energy, net force and torque of a shaken cell with one more term, and no force where it is at
/// rest.
template <class T>
void hold_to_its_energy(std::unique_ptr<T> (*make)(std::shared_ptr<CellSurfaces>), const double at_rest) {
  Cell cell;
  cell.system.add(make(cell.surfaces));
  cell.system.compute_forces();
  const double force = test::largest_component(cell.p);
  BOOST_TEST(force <= at_rest);
  cell.shake(0.3e-6);
  BOOST_TEST(slope_error(cell.system, 2e-9, 5) < 1e-6);
  BOOST_TEST(cell.imbalance() < 1e-12);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(cortex)

BOOST_AUTO_TEST_CASE(forces_are_slopes_of_energies_and_conserve_momentum_and_its_moment) {
  hold_to_its_energy(linear_edges, 0.);
  hold_to_its_energy(fene_edges, 1e-18);
  hold_to_its_energy(hinges, 1e-24);
  hold_to_its_energy(local_area, 1e-20);
  hold_to_its_energy(whole_area, 1e-20);
  hold_to_its_energy(tension, 1e-8);
  hold_to_its_energy(content, 1e-20);
}

BOOST_AUTO_TEST_CASE(springs_by_hand) {
  const LinearSpring linear = LinearSpring::of_cortex(1000., 500e-9);
  BOOST_TEST(linear.k == 4.330127018922e-4,
             boost::test_tools::tolerance(1e-12));  // the thesis's own 4e-4 N/m
  BOOST_TEST(linear.force(3e-6, 2e-6) == 4.330127018922e-10, boost::test_tools::tolerance(1e-12));
  const FeneSpring fene{1., 0.5};
  // l = 1.5 l0: x = 3/4, 1.5/(7/16) - 1/(3/4 2.25)
  BOOST_TEST(fene.force(3., 2.) == 2. * (1.5 / (7. / 16.) - 1. / (0.75 * 2.25)),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(fene.force(2., 2.)) < 1e-15);
  BOOST_TEST(fene.force(1.9, 2.) < 0.);
  BOOST_TEST(!fene.holds(4., 2.));
  BOOST_TEST(fene.holds(3.999, 2.));
  const double h = 1e-5;
  for (const double l : {1.2, 2., 3.3}) {
    BOOST_TEST((fene.energy(l + h, 2.) - fene.energy(l - h, 2.)) / (2. * h) == fene.force(l, 2.),
               boost::test_tools::tolerance(1e-8));
    BOOST_TEST((fene.force(l + h, 2.) - fene.force(l - h, 2.)) / (2. * h) == fene.stiffness(l, 2.),
               boost::test_tools::tolerance(1e-8));
  }
  const FeneSpring net = FeneSpring::of_net(6.3e-6, 0.4878);
  BOOST_TEST(std::sqrt(3.) / 4. * net.stiffness(1., 1.) == 6.3e-6, boost::test_tools::tolerance(1e-12));
}
/// At rest there is no stress, and what implicit steps see is all of the stiffness: (m + K) v = F(x + d) - m
/// d at x has the solution -d.
template <class T>
void implicit_steps_see_all_at_rest(std::unique_ptr<T> (*make)(std::shared_ptr<CellSurfaces>),
                                    const double stiffness) {
  Cell cell;
  cell.system.add(make(cell.surfaces));
  const double m = 0.05 * stiffness;
  const auto x = cell.p.x;
  cell.shake(1e-12);
  cell.system.compute_forces();
  auto f = cell.p.f, d = x, v = x;
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < cell.p.size(); ++i) {
      d[k][i] = cell.p.x[k][i] - x[k][i];
      f[k][i] -= m * d[k][i];
      v[k][i] = 0.;
    }
  cell.p.x = x;
  MotionMatrix matrix({.tolerance = 1e-9});
  matrix.clear(std::vector<double>(cell.p.size(), m));
  cell.system.collect(matrix, 1.);
  if (std::is_same_v<T, CortexEdges<LinearSpring>>) {  // the dashpots: not wanted here
    matrix.clear(std::vector<double>(cell.p.size(), m));
    CortexEdges<LinearSpring>(cell.surfaces, {4e-4}, 0.).collect(matrix, cell.p, 1.);
  }
  matrix.solve<3>(f, v, 1);
  double worst = 0.;
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < cell.p.size(); ++i) worst = std::max(worst, std::abs(v[k][i] + d[k][i]));
  BOOST_TEST(worst < 1e-4 * 1e-12);
}

BOOST_AUTO_TEST_CASE(implicit_steps_see_the_stiffness_at_rest) {
  implicit_steps_see_all_at_rest(linear_edges, 4e-4);
  implicit_steps_see_all_at_rest(hinges, 2e-17 / (3e-6 * 3e-6));
  implicit_steps_see_all_at_rest(local_area, 8e-4);
  implicit_steps_see_all_at_rest(whole_area, 8e-4);
  implicit_steps_see_all_at_rest(content, 2500. * 1e-5);
}

// The second derivative of a triangle's area by one of its nodes is what the other two, held, let it resist
// out of the plane: nothing is left out then.
BOOST_AUTO_TEST_CASE(implicit_steps_see_what_tension_resists_out_of_the_plane) {
  Cell cell;
  cell.shake(0.3e-6);
  cell.system.add(tension(cell.surfaces));
  const std::uint32_t node = 17;
  const double h = 1e-9, m = 1e-6;
  Tensor2<3> K;
  for (int d = 0; d < 3; ++d) {
    const double x = cell.p.x[d][node];
    cell.p.x[d][node] = x - h;
    cell.system.compute_forces();
    const Vector<3> before = cell.force(node);
    cell.p.x[d][node] = x + h;
    cell.system.compute_forces();
    K.col(d) = (before - cell.force(node)) / (2. * h);
    cell.p.x[d][node] = x;
  }
  cell.system.compute_forces();
  MotionMatrix matrix({.tolerance = 1e-9});
  std::vector<double> medium(cell.p.size(), 1e3);
  medium[node] = m;
  matrix.clear(medium);
  cell.system.collect(matrix, 1.);
  auto v = cell.p.f;
  matrix.solve<3>(cell.p.f, v, 1);
  const Vector<3> found(v[0][node], v[1][node], v[2][node]);
  const Vector<3> by_hand = (m * Tensor2<3>::Identity() + K).ldlt().solve(cell.force(node));
  BOOST_TEST((found - by_hand).norm() < 1e-5 * by_hand.norm());
}

BOOST_AUTO_TEST_CASE(rigid_motions_rub_nowhere) {
  Cell cell;
  cell.shake(0.3e-6);
  auto &edges = cell.system.add(linear_edges(cell.surfaces));
  const Vector<3> travel(1e-6, -2e-6, 0.5e-6), spin(0.1, 0.3, -0.2);
  std::vector<double> medium(cell.p.size(),
                             1e-4);  // as the dashpots' coefficient, of which what they leave is told
  for (std::size_t i = 0; i < cell.p.size(); ++i) {
    const Vector<3> v = travel + spin.cross(cell.p.position(i));
    for (int d = 0; d < 3; ++d) {
      cell.p.v[d][i] = v[d];
      cell.p.f[d][i] = medium[i] * v[d];
    }
  }
  // over that of nodes that move as fast, but each for itself
  BOOST_TEST(edges.dissipation(cell.p, 0) < 1e-24 * 1e-4 * 480. * 4e-6 * 4e-6);
  MotionMatrix matrix({.tolerance = 1e-12});
  matrix.clear(medium);
  edges.collect(matrix, cell.p, 0.);
  auto v = cell.p.v;
  matrix.solve<3>(cell.p.f, v, 1);  // starts at the solution, and the residual says so
  BOOST_TEST(matrix.iterations() == 0u);
  double worst = 0.;
  for (int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < cell.p.size(); ++i)
      worst = std::max(worst, std::abs(v[d][i] - cell.p.v[d][i]));
  BOOST_TEST(worst < 1e-12 * 4e-6);
}
BOOST_AUTO_TEST_SUITE_END()
