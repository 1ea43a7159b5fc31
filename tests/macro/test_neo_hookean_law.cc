#include "tests/macro/tissue_fixture.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(neo_hookean_law)

namespace {
LawAnswer<2> ask(NeoHookeanLaw<2> &law, const dealii::Tensor<2, 2> &F, const dealii::Tensor<2, 2> &F_dot) {
  LawRequest request;
  request.tangents = request.rate_tangents = true;
  LawAnswer<2> answer;
  law.evaluate({F}, {F_dot}, request, answer);
  return answer;
}

dealii::Tensor<2, 2> matrix(double a, double b, double c, double d) {
  dealii::Tensor<2, 2> F;
  F[0][0] = a;
  F[0][1] = b;
  F[1][0] = c;
  F[1][1] = d;
  return F;
}
}  // namespace

BOOST_AUTO_TEST_CASE(stretch_to_double_length_by_hand) {
  NeoHookeanLaw<2> law(2., 3., 0., 1.);
  const LawAnswer<2> answer = ask(law, matrix(2., 0., 0., 1.), matrix(0., 0., 0., 0.));
  const double log_2 = std::log(2.);
  BOOST_TEST(answer.P[0][0][0] == 2. * (2. - 0.5) + 3. * log_2 / 2., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(answer.P[0][1][1] == 3. * log_2, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(answer.energy[0] == 5. - 2. - 2. * log_2 + 1.5 * log_2 * log_2,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(newtonian_shear_by_hand) {
  NeoHookeanLaw<2> law(2., 3., 0.7, 1.);
  const LawAnswer<2> answer = ask(law, matrix(1., 0., 0., 1.), matrix(0., 5., 0., 0.));
  BOOST_TEST(answer.P[0][0][1] == 0.7 * 5., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(answer.P[0][1][0] == 0.7 * 5., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(answer.P[0][0][0] == 0.);
}

BOOST_AUTO_TEST_CASE(bounds_hold_and_are_reached_at_rest) {
  NeoHookeanLaw<2> law(2., 30., 0.7, 1.);
  BOOST_TEST(law.stiffness_bound() == 2. * 2. + 2. * 30.);  // dF = I / sqrt(2)
  for (const double t : {0., 0.3, 1.1, 2.3}) {
    const auto F = matrix(1. + 0.3 * std::sin(t), 0.4 * std::cos(t), -0.2 * std::sin(2. * t), 0.8 + 0.1 * t);
    const LawAnswer<2> answer = ask(law, F, matrix(0., 0., 0., 0.));
    law.commit();
    for (const double s : {0.1, 0.9, 1.7, 2.5}) {
      const auto dF = matrix(std::cos(s), std::sin(2. * s), std::cos(3. * s), std::sin(4. * s));
      const double form =
          dealii::scalar_product(dF, dealii::double_contract<2, 0, 3, 1>(answer.tangent[0], dF));
      BOOST_TEST(form <= law.stiffness_bound() * dF.norm_square());
      const LawAnswer<2> moving = ask(law, F, dF);
      BOOST_TEST(dealii::scalar_product(dF, moving.P[0] - answer.P[0]) <=
                 law.viscosity_bound() * dF.norm_square());
      // linear in the rate
      const auto slope = dealii::double_contract<2, 0, 3, 1>(answer.rate_tangent[0], dF);
      BOOST_TEST((slope - (moving.P[0] - answer.P[0])).norm() <
                 1e-13 * (moving.P[0].norm() + answer.P[0].norm()));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_rigid_spin_costs_nothing) {
  NeoHookeanLaw<2> law(2., 30., 0.7, 1.);
  const auto F = matrix(1.3, 0.4, -0.2, 0.9);
  const LawAnswer<2> answer = ask(law, F, matrix(0., 0., 0., 0.));
  BOOST_TEST(
      (dealii::double_contract<2, 0, 3, 1>(answer.rate_tangent[0], matrix(0., -1., 1., 0.) * F).norm() <
       1e-15));
}

BOOST_AUTO_TEST_CASE(turned_inside_out_is_refused_with_a_reason) {
  NeoHookeanLaw<2> law(2., 3., 0., 1.);
  const LawAnswer<2> answer = ask(law, matrix(-1., 0., 0., 1.), matrix(0., 0., 0., 0.));
  BOOST_REQUIRE(answer.failed.size() == 1u);
  BOOST_TEST(answer.failed[0].reason.find("inside out") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
