// The scene cylinder_array: its exact drag beside the published table and series, the particles beside it,
// the same bits on threads and after a stop.
#include "micro/scenes/reference/cylinder_array.h"
#include "micro/scenes/stokes/cylinder_array.h"
#include "tests/micro/run_of_scene.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(cylinder_array)

BOOST_AUTO_TEST_CASE(exact_drag_is_the_published_one) {
  const double table[][2] = {{0.05, 15.56}, {0.1, 24.83}, {0.2, 51.53}, {0.5, 532.55}};
  for (const auto &[c, drag] : table) BOOST_TEST(std::abs(cylinder_array_drag(c) - drag) < 6e-3);
  BOOST_TEST(std::abs(dilute_array_drag(0.01) / cylinder_array_drag(0.01) - 1.) < 1e-3);
  BOOST_CHECK_THROW(cylinder_array_drag(0.7), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(drag_of_particles) {
  const std::string text = "set Samples = 4\nset Frames = 0\nset End time = 0.02\nset Particles across = ";
  const auto coarse = test::run<CylinderArray>(text + "16", 1, 0, "drag").results;
  const auto usual = test::run<CylinderArray>(text + "30", 1, 0, "drag").results;
  BOOST_TEST_MESSAGE("errors of the drag " << coarse.at("drag_error") << ", " << usual.at("drag_error"));
  BOOST_TEST(std::abs(usual.at("drag_error")) < 0.03);
  BOOST_TEST(usual.at("momentum_balance") < 5e-3);
  BOOST_TEST(std::abs(usual.at("energy_balance")) < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_fluid_too_soft_is_told) {
  const std::string text =
      "set Samples = 4\nset Frames = 0\nset End time = 0.01\nset Particles across = 12\n";
  BOOST_TEST(!test::run<CylinderArray>(text, 1, 0, "drag").notes.count("drag"));
  const auto soft =
      test::run<CylinderArray>(text + "subsection Fluid\n set Bulk modulus = 1\nend\n", 1, 0, "drag");
  BOOST_TEST(soft.notes.at("drag").find("Fluid/Bulk modulus (1 Pa) is less than 100 times") == 0);
}

BOOST_AUTO_TEST_CASE(same_bits_on_threads_and_after_a_stop) {
  const std::string text =
      "set Samples = 4\nset Frames = 0\nset End time = 0.02\nset Particles across = 24\n";
  const auto once = test::run<CylinderArray>(text, 1, 0, "drag");
  BOOST_TEST((test::run<CylinderArray>(text, 3, 0, "drag").rows == once.rows));
  BOOST_TEST((test::run<CylinderArray>(text, 1, 8, "drag").rows == once.rows));
}

BOOST_AUTO_TEST_SUITE_END()
