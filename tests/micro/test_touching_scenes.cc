// Scenes of deformable cells that touch: the same bits after a stop and on threads, and the other solutions
// that they are held against.
#include "micro/scenes/deformable/capsule_compression.h"
#include "micro/scenes/deformable/cell_between_plates.h"
#include "micro/scenes/deformable/doublet.h"
#include "micro/scenes/deformable/pull_off.h"
#include "micro/scenes/deformable/spreading.h"
#include "micro/scenes/reference/squeezed_drop.h"
#include "micro/terms/centre_spring.h"
#include "run_of_scene.h"
#include "slope_of_energy.h"

#include <numbers>

using namespace turgor;
using namespace turgor::test;

namespace {
const char *const coarse =
    "set Fields = false\nset Samples = 20\nsubsection Cell\n set Frequency = 3\nend\nsubsection Contact\n "
    "set Gap at rest = 0.3e-6\n set Range = 0.75e-6\nend\n";
const std::string
    clump = std::string(
                "set Cells = 3\nset Last radius = 16e-6\nset Compression time = 400\nset Hold time = 20\n") +
            coarse,
    plates = std::string("set Compression time = 20\nset Hold time = 20\n") + coarse;

AxialShellParameters round_cell(const double adhesion) {
  const double h = 500e-9;
  return {10e-6, 0.5 * std::sqrt(3.) * 1000. * h,  2. / std::sqrt(3.) * 1000. * h * h * h / 9., 8e-4, 0.,
          2500., {adhesion, 0.4e-6, 0.25e-6, 3e10}};
}
}  // namespace

BOOST_AUTO_TEST_SUITE(touching_scenes)

BOOST_AUTO_TEST_CASE(stopped_runs_go_on_with_the_same_bits_and_threads_do_not_matter) {
  const Outcome spread = run<Spreading>(coarse, 1, 0, "history"),
                squeezed = run<CellBetweenPlates>(plates, 1, 0, "history"),
                pressed = run<CapsuleCompression>(clump, 1, 0, "history");
  for (const unsigned long stop : {3ul, 40ul}) {
    BOOST_TEST((run<Spreading>(coarse, 1, stop, "history").rows == spread.rows));
    BOOST_TEST((run<CellBetweenPlates>(plates, 1, stop, "history").rows == squeezed.rows));
    BOOST_TEST((run<CapsuleCompression>(clump, 1, stop, "history").rows == pressed.rows));
  }
  for (const unsigned int threads : {2u, 3u})
    BOOST_TEST((run<CapsuleCompression>(clump, threads, 0, "history").rows == pressed.rows));
  BOOST_TEST((run<CellBetweenPlates>(plates, 2, 0, "history").rows == squeezed.rows));
  BOOST_TEST(pressed.results.at("volume_strain") > 0.02);
}

BOOST_AUTO_TEST_CASE(drawn_off_and_adhering_cells_go_on_with_the_same_bits_and_threads_do_not_matter) {
  const std::string draw = std::string("set Pull distance = 0.4e-6\nset From = cell\n") + coarse;
  const Outcome drawn = run<PullOff>(draw, 1, 0, "history"), pair = run<Doublet>(coarse, 1, 0, "history");
  for (const unsigned long stop : {3ul, 100ul}) {
    const Outcome again = run<PullOff>(draw, 1, stop, "history");
    BOOST_TEST((again.rows == drawn.rows));
    BOOST_TEST((again.results == drawn.results));
    BOOST_TEST((run<Doublet>(coarse, 1, stop, "history").rows == pair.rows));
  }
  BOOST_TEST((run<PullOff>(draw, 2, 0, "history").rows == drawn.rows));
  BOOST_TEST((run<Doublet>(coarse, 2, 0, "history").rows == pair.rows));
}

BOOST_AUTO_TEST_CASE(a_spring_on_centres_is_the_slope_of_its_energy) {
  for (const int cells : {1, 2}) {
    ParticleSystem<3> system;
    auto surfaces = std::make_shared<CellSurfaces>();
    const DeformableShape shape = sphere_shape(2, 10e-6);
    for (int c = 0; c < cells; ++c) surfaces->add(system.particles, shape.mesh, shape.nodes);
    for (std::size_t i = 0; i < system.particles.size(); ++i)
      system.particles.x[0][i] += 1e-6 * double(i % 7);
    CentreSpring &spring = system.add(std::make_unique<CentreSpring>(Vector<3>(0.6, 0., 0.8), 0.01));
    spring.hold(3e-6);
    BOOST_TEST(slope_error(system, 1e-9, 1) < 1e-6);
    double net = 0.;
    for (const double f : system.particles.f[2]) net += f;
    BOOST_TEST(net == (cells == 1 ? 0.8 * spring.force() : 0.), boost::test_tools::tolerance(1e-9));
  }
}

// At rest the spring's force is the slope of the energy over where it holds.
BOOST_AUTO_TEST_CASE(a_shell_is_drawn_off_by_the_slope_of_its_energy) {
  AxialShellParameters cell = round_cell(1e-5);
  cell.contact.range = 1.5e-6;
  AxialShell shell(cell, 80);
  shell.relax();
  shell.grip = 0.01;
  const double at = shell.mean_height() + 0.4e-6, by = 2e-9;
  double energy[2];
  for (int side = 0; side < 2; ++side) {
    shell.held_at = at + (side == 0 ? -by : by);
    shell.relax();
    energy[side] = shell.energy();
  }
  shell.held_at = at;
  shell.relax();
  BOOST_TEST(shell.grip_force() > 0.);
  BOOST_TEST((energy[1] - energy[0]) / (2. * by) == shell.grip_force(), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_cell_is_drawn_off_as_a_shell_of_revolution_is) {
  const Outcome drawn = run<PullOff>(
      "set Fields = false\nset Longest step = 50\nsubsection Cell\n set Frequency = 4\nend\nsubsection "
      "Contact\n set Range = 1.5e-6\nend\n",
      1, 0, "history");
  const double shell = drawn.results.at("axial_relative_pull_off");
  BOOST_TEST(shell > 1.);  // between a vesicle and DMT
  BOOST_TEST(shell < 2.);
  BOOST_TEST(drawn.results.at("relative_pull_off") == shell, boost::test_tools::tolerance(0.15));
  BOOST_TEST(std::abs(drawn.results.at("force_at_end")) < 0.02 * drawn.results.at("pull_off_force"));
}

BOOST_AUTO_TEST_CASE(tense_cells_meet_at_the_angle_of_young_and_dupre) {
  const Outcome pair =
      run<Doublet>("set Fields = false\nsubsection Cell\n set Frequency = 5\nend\n", 1, 0, "history");
  BOOST_TEST(pair.results.at("young_dupre_angle") == 36.8699, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(std::abs(pair.results.at("angle_deviation")) < 4.);
}

// With strong adhesion it is stretched everywhere.
BOOST_AUTO_TEST_CASE(the_cortex_is_compressed_where_two_cells_adhere_weakly) {
  const Outcome pair = run<Doublet>(
      "set Fields = false\nset End time = 1e6\nset Longest step = 1e5\nsubsection Cell\n set Frequency = 4\n "
      "set Cortex tension = 0\n set Cortex modulus = 1000\n set Cortex friction = 1e-4\n set Area modulus = "
      "8e-4\n set Bulk modulus = 2500\nend\nsubsection Contact\n set Adhesion = 1e-6\n set Range = "
      "1.5e-6\nend\n",
      1, 0, "history");
  BOOST_TEST(pair.results.at("stress_in_contact") < 0.);
  BOOST_TEST(pair.results.at("stress_outside") > 0.);
}

BOOST_AUTO_TEST_CASE(a_cell_spreads_as_far_as_a_shell_of_revolution) {
  const Outcome spread = run<Spreading>(
      "set Fields = false\nsubsection Cell\n set Frequency = 4\nend\nsubsection Contact\n set Range = "
      "1.5e-6\nend\n",
      1, 0, "history");
  BOOST_TEST(std::abs(spread.results.at("axial_deviation")) < 0.05);
  BOOST_TEST(spread.results.at("mesh_ratio") > 1.5);
  for (std::size_t k = 1; k < spread.rows.size(); ++k) {  // energy falls, but for the round-off of its sum
    const double before = spread.rows[k - 1][5];
    BOOST_TEST(spread.rows[k][5] <= before + 1e-14 * std::abs(before));
  }
}

BOOST_AUTO_TEST_CASE(tension_and_pressure_between_plates_are_those_put_in) {
  const Outcome squeezed = run<CellBetweenPlates>(
      "set Fields = false\nset Compression time = 20\nset Hold time = 20\nsubsection Cell\n set Frequency = "
      "4\nend\n",
      1, 0, "history");
  BOOST_TEST(std::abs(squeezed.results.at("tension_deviation")) < 0.05);
  BOOST_TEST(std::abs(squeezed.results.at("pressure_deviation")) < 0.05);
}

// Of a pancake much wider than high the free surface is half a circle: c -> 1/height.
BOOST_AUTO_TEST_CASE(squeezed_drop_in_closed_form) {
  BOOST_TEST(SqueezedDrop::height(0., 2.) == 2., boost::test_tools::tolerance(1e-6));
  const SqueezedDrop flat(1., 1000.);
  BOOST_TEST(flat.tension(1e-6) == 0.5 * 1e-6 / (std::numbers::pi * 999. * 999.) * 2. / 1.,
             boost::test_tools::tolerance(5e-3));
  // near to a ball a small force flattens it: p pi a^2 = F, p = 2 gamma/R
  const SqueezedDrop ball(0.999, 1.0003);
  BOOST_TEST(ball.sharpness == 1., boost::test_tools::tolerance(5e-3));
}

BOOST_AUTO_TEST_CASE(shell_of_revolution_in_closed_form) {
  // tension and content alone: Laplace
  AxialShellParameters tense = round_cell(0.);
  tense.spring = 1e-9;
  tense.area = 0.;
  tense.bending = 1e-22;
  tense.tension = 1e-3;
  AxialShell drop(tense, 60);
  drop.relax();
  const double radius = std::cbrt(drop.volume() * 3. / (4. * std::numbers::pi));
  BOOST_TEST(drop.pressure() == 2e-3 / radius, boost::test_tools::tolerance(2e-3));
  // a balloon at rest stays as it is
  AxialShell still(round_cell(0.), 60);
  BOOST_TEST(still.relax() <= 3u);
  BOOST_TEST(std::abs(still.pressure()) < 1e-6);
}

// The same minimum on meshes of other sizes, and what the trial's own solver found with a range of 0.2 um:
// 10.63 um at 1e-4 J/m^2, on a coarser one.
BOOST_AUTO_TEST_CASE(shell_of_revolution_converges) {
  double radius[2];
  for (int k = 0; k < 2; ++k) {
    AxialShell shell(round_cell(1e-4), k == 0 ? 100 : 200);
    shell.relax();
    radius[k] = shell.contact_radius();
  }
  BOOST_TEST(radius[0] == radius[1], boost::test_tools::tolerance(5e-3));
  AxialShellParameters sharp = round_cell(1e-4);
  sharp.contact.range = 0.2e-6;
  AxialShell shell(sharp, 200);
  shell.relax();
  BOOST_TEST(shell.contact_radius() == 10.63e-6, boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(second_order_by_hand) {
  using S = SecondOrder<2>;
  const S x = S::variable(3., 0), y = S::variable(4., 1), r = sqrt(x * x + y * y), angle = atan2(y, x);
  BOOST_TEST(r.value == 5.);
  BOOST_TEST(r.gradient[0] == 0.6, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(r.second(0, 1) == -12. / 125., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(angle.gradient[0] == -4. / 25., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(angle.second(0, 0) == 24. / 625., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(angle.second(0, 1) == (16. - 9.) / 625., boost::test_tools::tolerance(1e-12));
  BOOST_TEST((x / y).second(1, 1) == 2. * 3. / 64., boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
