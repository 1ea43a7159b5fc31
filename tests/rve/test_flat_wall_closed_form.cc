// The closed form of errata.md by its printed numbers.
#include "rve/flat_wall_closed_form.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(flat_wall_closed_form)

BOOST_AUTO_TEST_CASE(numbers_of_the_errata) {
  const FlatWallClosedForm form({});
  BOOST_TEST(std::abs(form.lambda_0() - 1.02575) < 5e-6);
  const auto shear = [&](const double b) {
    Tensor2<2> F;
    F << 1., b, 0., 1.;
    return form.stress(F)(0, 1);
  };
  BOOST_TEST(std::abs(shear(0.05) - 10.47e3) < 5.);
  BOOST_TEST(std::abs(shear(0.3) - 150.6e3) < 50.);
  BOOST_TEST(std::abs(shear(1.) - 1678.9e3) < 50.);
  Tensor2<2> F;
  F << 1.02, 0., 0., 1. / 1.02;
  const Tensor2<2> sigma = form.stress(F);
  BOOST_TEST(std::abs(sigma(0, 0) - sigma(1, 1) - 314.3e3) < 50.);
  BOOST_TEST(form.stress(Tensor2<2>::Identity()).norm() < 1e-6);
}

BOOST_AUTO_TEST_CASE(biaxial_as_printed_and_objective) {
  const ParenchymaParameters p;
  const FlatWallClosedForm form(p);
  const NeoHookeanWall wall(p.wall_stiffness, p.depth, p.wall_beta);
  Tensor2<2> F;
  F << 1.03, 0., 0., 0.98;
  // sigma_xx = n F(lambda_0 lambda_x)/(lambda_y L z0) - p(A)
  const double expected =
      2. * wall.force(form.lambda_0() * 1.03) / (0.98 * p.period * p.depth) - form.pressure(F);
  BOOST_TEST(form.stress(F)(0, 0) == expected, boost::test_tools::tolerance(1e-12));
  Tensor2<2> Q;
  Q << 0.8, -0.6, 0.6, 0.8;
  F << 1.01, 0.2, 0.05, 1.1;
  BOOST_TEST((form.stress(Q * F) - Q * form.stress(F) * Q.transpose()).norm() < 1e-9 * form.stress(F).norm());
  BOOST_TEST(form.applies(F));
  F << 0.9, 0., 0., 1.1;
  BOOST_TEST(!form.applies(F));
}

BOOST_AUTO_TEST_SUITE_END()
