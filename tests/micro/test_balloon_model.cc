// The reference solver of a squeezed balloon against its own limits, before anything is compared with it.
#include "micro/scenes/reference/balloon_model.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;

namespace {
BalloonModel balloon(const BalloonModel::Membrane membrane, const double turgor, const double bulk_modulus) {
  BalloonModel model;
  model.rest_radius = 30e-6;
  model.wall_stiffness = 100.;
  model.membrane = membrane;
  model.bending = 100. * 126e-9 * 126e-9 / 3.;
  // turgor where 2 T = p R
  double lambda = 1.;
  for (int k = 0; k < 100; ++k)
    lambda = std::pow(1. - turgor * lambda * model.rest_radius / (2. * model.wall_stiffness), -1. / 6.);
  const double V0 = 4. / 3. * std::numbers::pi * std::pow(lambda * model.rest_radius, 3);
  model.pressure_of_volume = [=](const double V) { return turgor + bulk_modulus * (V0 / V - 1.); };
  return model;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(balloon_model)

BOOST_AUTO_TEST_CASE(tensions_are_slopes_of_one_energy_and_agree_equibiaxially) {
  for (const auto membrane : {BalloonModel::Membrane::net, BalloonModel::Membrane::neo_hookean}) {
    const BalloonModel model = balloon(membrane, 200e3, 42e6);
    for (const double l : {0.95, 1.01, 1.3})
      BOOST_TEST(model.tension(l, l).t1 == 100. * (1. - std::pow(l, -6.)),
                 boost::test_tools::tolerance(1e-10));
    const double a = 1.1, b = 1.25, h = 1e-6;
    const auto T = model.tension(a, b);
    BOOST_TEST(T.t1_by_1 == (model.tension(a + h, b).t1 - model.tension(a - h, b).t1) / (2 * h),
               boost::test_tools::tolerance(1e-7));
    BOOST_TEST(T.t1_by_2 == (model.tension(a, b + h).t1 - model.tension(a, b - h).t1) / (2 * h),
               boost::test_tools::tolerance(1e-7));
    // d(lambda_2 T_1)/dlambda_2 = d(lambda_1 T_2)/dlambda_1: there is an energy
    BOOST_TEST(((b + h) * model.tension(a, b + h).t1 - (b - h) * model.tension(a, b - h).t1) ==
                   a * (model.tension(a + h, b).t2 - model.tension(a - h, b).t2) + 2 * h * T.t2,
               boost::test_tools::tolerance(1e-6));
    BOOST_TEST(T.t2 == model.tension(b, a).t1, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(a_yielding_net_has_the_slopes_and_the_energy_of_its_tensions) {
  BalloonModel model = balloon(BalloonModel::Membrane::net, 200e3, 42e6);
  model.yield = {15., 0.9};
  const double a = 1.03, b = 1.08, h = 1e-6;
  // equibiaxially every spring has the same stretch: G t0 g (1 - l^-6)
  BOOST_TEST(model.tension(b, b).t1 == 100. * model.yield.share(b) * (1. - std::pow(b, -6.)),
             boost::test_tools::tolerance(1e-10));
  const auto T = model.tension(a, b);
  BOOST_TEST(T.t1_by_1 == (model.tension(a + h, b).t1 - model.tension(a - h, b).t1) / (2 * h),
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(T.t1_by_2 == (model.tension(a, b + h).t1 - model.tension(a, b - h).t1) / (2 * h),
             boost::test_tools::tolerance(1e-6));
  // lambda_2 T_1 = dW/dlambda_1; the rule of 12 points has W to 1e-9
  BOOST_TEST(b * T.t1 == (model.tension(a + h, b).w - model.tension(a - h, b).w) / (2 * h),
             boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(a_wall_breaks_where_its_largest_stretch_is) {
  BalloonModel model = balloon(BalloonModel::Membrane::net, 200e3, 42e6);
  model.elements = 60;
  const auto points = model.compress(0.2, 0.02);
  const auto first = BalloonModel::first_break(points, 1.03);
  BOOST_TEST(
      (first.deformation > points.front().deformation && first.deformation < points.back().deformation));
  std::size_t k = 0;
  while (points[k].deformation < first.deformation) ++k;
  BOOST_TEST(BalloonModel::largest(points[k - 1], first.direction).stretch <= 1.03);
  BOOST_TEST(BalloonModel::largest(points[k], first.direction).stretch >= 1.03);
  BOOST_TEST(std::isnan(BalloonModel::first_break(points, 2.).deformation));
  // on a plate that holds it nothing slides: what touches keeps its distance from the axis
  model.sticking = true;
  const auto stuck = model.compress(0.2, 0.02);
  for (std::size_t i = 0; i + 1 < stuck[4].touching; ++i)
    for (int d = 0; d < 2; ++d)
      BOOST_TEST(stuck[4].stretches[i][d] == stuck.back().stretches[i][d],
                 boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(force_is_the_slope_of_the_energy_and_balances_the_equator) {
  BalloonModel model = balloon(BalloonModel::Membrane::net, 200e3, 42e6);
  model.elements = 200;
  const double R = model.turgid_radius();
  BOOST_TEST(model.pressure_of_volume(4. / 3. * std::numbers::pi * R * R * R) == 200e3,
             boost::test_tools::tolerance(1e-8));
  const auto points = model.compress(0.06, 0.002);
  const double height = 2. * R;
  for (std::size_t k = 1; k < points.size(); ++k) {
    // what the equator carries, the plate carries: second order in the elements, (pi/400)^2 of 2 T rho = p
    // rho^2
    BOOST_TEST(std::abs(points[k].force_balance) < 1e-3);
    // F dX = dE of the wall - p dV, by the trapezoidal rule, which is good once F has grown over a few steps
    // (F ~ X^1.3)
    if (k < 4) continue;
    const double dX = height * (points[k].deformation - points[k - 1].deformation);
    const double dE =
        points[k].energy - points[k - 1].energy -
        0.5 * (points[k].pressure + points[k - 1].pressure) * (points[k].volume - points[k - 1].volume);
    BOOST_TEST(0.5 * (points[k].force + points[k - 1].force) * dX == dE, boost::test_tools::tolerance(0.01));
  }
}

BOOST_AUTO_TEST_CASE(force_is_pressure_times_contact) {
  BalloonModel model = balloon(BalloonModel::Membrane::neo_hookean, 200e3, 42e6);
  model.elements = 200;
  model.bending = 0.;  // it would add a line force at the edge
  const auto points = model.compress(0.05);
  const double a = points.back().contact_radius,
               width = 0.5 * std::numbers::pi * model.rest_radius / model.elements;
  // the contact ends somewhere in the element behind its last node
  BOOST_TEST(points.back().force >= 0.9 * points.back().pressure * std::numbers::pi * a * a);
  BOOST_TEST(points.back().force <=
             points.back().pressure * std::numbers::pi * (a + 2. * width) * (a + 2. * width));
  BOOST_TEST(std::isnan(BalloonModel::force_at(points, 0.5)));
  BOOST_TEST(BalloonModel::force_at(points, points[2].deformation) == points[2].force,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(finer_elements_change_less_and_less) {
  double force[3];
  for (int k = 0; k < 3; ++k) {
    BalloonModel model = balloon(BalloonModel::Membrane::net, 200e3, 42e6);
    model.elements = 50u << k;
    force[k] = BalloonModel::force_at(model.compress(0.16, 0.02), 0.15);
  }
  BOOST_TEST_MESSAGE("force at 15 % with 50, 100, 200 elements: " << force[0] << " " << force[1] << " "
                                                                  << force[2]);
  // the contact's edge jumps from node to node: first order, 2/50 of the contact's radius and less
  BOOST_TEST(std::abs(force[2] / force[1] - 1.) < 0.04);
}

BOOST_AUTO_TEST_SUITE_END()
