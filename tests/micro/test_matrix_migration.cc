// The degradation of a matrix, and the scene matrix_migration against the closed forms of both plateaus.
#include "micro/scenes/stokes/matrix_migration.h"
#include "tests/micro/run_of_scene.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(matrix_migration)

BOOST_AUTO_TEST_CASE(degradation_by_hand) {
  const MatrixDegradation cone{.rate = 2., .radius = 1., .decay = 0.25, .cutoff = 2., .least_cosine = 0.5};
  const Vector<2> ahead(1., 0.);
  BOOST_TEST(std::abs(cone.at<2>(Vector<2>(1.25, 0.), ahead) - 2. / std::numbers::e) < 1e-14);
  BOOST_TEST(cone.at<2>(Vector<2>(2.1, 0.), ahead) == 0.);
  BOOST_TEST(cone.at<2>(Vector<2>(0., 1.2), ahead) == 0.);
  BOOST_TEST(MatrixDegradation::after(0.3, 2., 0.1) == 0.3 - 0.2);
  BOOST_TEST(MatrixDegradation::after(0.3, 2., 1.) == 0.);
}

/// A disc of matrix 300 um across: both plateaus of the speed.
BOOST_AUTO_TEST_CASE(plateaus_of_the_intact_and_of_the_degraded_matrix) {
  const std::string disc =
      "set Domain = disc\nset Width = 300e-6\nset End time = 3\nset Samples = 4\nset Frames = 0\n"
      "subsection Cell\nset Spread = 0\nend\n";
  const auto intact =
      test::run<MatrixMigration>(disc +
                                     "subsection Degradation\nset Rate = 0\nset Ring = 0\nend\nsubsection "
                                     "Motion\nset Longest step = 0.01\nend\n",
                                 1, 0, "migration");
  const double far = intact.results.at("compliance") / intact.results.at("intact_compliance");
  const auto loose =
      test::run<MatrixMigration>(disc + "subsection Degradation\nset Ring = 100\nend\n", 1, 0, "migration");
  const double fast = loose.results.at("mobility") / loose.results.at("degraded_mobility");
  BOOST_TEST_MESSAGE(
      "way in the intact matrix over the closed form: " << far << ", speed in the degraded: " << fast);
  BOOST_TEST(std::abs(far - 1.) < 0.05);
  BOOST_TEST(std::abs(fast - 1.) < 0.05);
  BOOST_TEST(std::abs(intact.results.at("energy_balance")) < 0.03);
  BOOST_TEST(intact.results.at("force_balance") < 1e-3);
  BOOST_TEST(std::abs(loose.results.at("energy_balance")) < 0.01);
  BOOST_TEST(loose.results.at("force_balance") < 1e-3);
}

/// Through the matrix that it degrades: no step makes or loses energy, however far the cell has come.
BOOST_AUTO_TEST_CASE(a_cell_on_its_way_keeps_the_balance) {
  const auto gone = test::run<MatrixMigration>(
      "set Length = 400e-6\nset Width = 300e-6\nset Spacing = 15e-6\nset End time = 4\nset Samples = 4\n"
      "set Frames = 0\nset Start = 0.3\nsubsection Cell\nset Force depth = cell\nset Radius = 30e-6\nend\n"
      "subsection Packing\nset Settling steps = 30\nend\n",
      1, 0, "migration");
  BOOST_TEST_MESSAGE("way " << gone.results.at("displacement") << " m, balance of energy "
                            << gone.results.at("energy_balance"));
  BOOST_TEST(gone.results.at("displacement") > 30e-6);
  BOOST_TEST(std::abs(gone.results.at("energy_balance")) < 0.03);
}

BOOST_AUTO_TEST_CASE(same_bits_on_threads_and_after_a_stop) {
  const std::string text =
      "set Domain = disc\nset Width = 200e-6\nset End time = 0.5\nset Samples = 4\nset Frames = 0\n"
      "subsection Cell\nset Force depth = cell\nset Radius = 25e-6\nend\n"
      "subsection Packing\nset Settling steps = 20\nend\n";
  const auto once = test::run<MatrixMigration>(text, 1, 0, "migration");
  BOOST_TEST((test::run<MatrixMigration>(text, 3, 0, "migration").rows == once.rows));
  BOOST_TEST((test::run<MatrixMigration>(text, 1, 20, "migration").rows == once.rows));
}

BOOST_AUTO_TEST_SUITE_END()
