// The reference solver of a squeezed balloon against its own limits, before anything is compared with it.
#include "micro/scenarios/balloon_model.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace turgor;

namespace
{
BalloonModel balloon(const BalloonModel::Membrane membrane, const double turgor, const double bulk_modulus)
{
  BalloonModel model;
  model.rest_radius = 30e-6;
  model.wall_stiffness = 100.;
  model.membrane = membrane;
  // turgor where 2 T = p R
  double lambda = 1.;
  for (int k = 0; k < 100; ++k)
    lambda = std::pow(1. - turgor * lambda * model.rest_radius / (2. * model.wall_stiffness), -1. / 6.);
  const double V0 = 4. / 3. * std::numbers::pi * std::pow(lambda * model.rest_radius, 3);
  model.pressure_of_volume = [=](const double V) { return turgor + bulk_modulus * (V0 / V - 1.); };
  return model;
}
} // namespace

BOOST_AUTO_TEST_SUITE(balloon_model)

BOOST_AUTO_TEST_CASE(tensions_are_slopes_of_one_energy_and_agree_equibiaxially)
{
  for (const auto membrane : {BalloonModel::Membrane::net, BalloonModel::Membrane::neo_hookean})
    {
      const BalloonModel model = balloon(membrane, 200e3, 42e6);
      for (const double l : {0.95, 1.01, 1.3})
        BOOST_TEST(model.tension(l, l).t1 == 100. * (1. - std::pow(l, -6.)), boost::test_tools::tolerance(1e-10));
      const double a = 1.1, b = 1.25, h = 1e-6;
      const auto T = model.tension(a, b);
      BOOST_TEST(T.t1_by_1 == (model.tension(a + h, b).t1 - model.tension(a - h, b).t1) / (2 * h),
                 boost::test_tools::tolerance(1e-7));
      BOOST_TEST(T.t1_by_2 == (model.tension(a, b + h).t1 - model.tension(a, b - h).t1) / (2 * h),
                 boost::test_tools::tolerance(1e-7));
      // d(lambda_2 T_1)/dlambda_2 = d(lambda_1 T_2)/dlambda_1: there is an energy
      BOOST_TEST(((b + h) * model.tension(a, b + h).t1 - (b - h) * model.tension(a, b - h).t1)
                   == a * (model.tension(a + h, b).t2 - model.tension(a - h, b).t2) + 2 * h * T.t2,
                 boost::test_tools::tolerance(1e-6));
      BOOST_TEST(T.t2 == model.tension(b, a).t1, boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(force_is_work_over_distance_and_balances_the_equator)
{
  // The energy that plates put in is the wall's and the fluid's; its derivative is the force: checked by the virtual-work
  // identity F dX = dE, with E integrated by an independent sum over the points found.
  for (const auto membrane : {BalloonModel::Membrane::net, BalloonModel::Membrane::neo_hookean})
    {
      const BalloonModel model = balloon(membrane, 200e3, 42e6);
      const double R = model.turgid_radius();
      BOOST_TEST(model.pressure_of_volume(4. / 3. * std::numbers::pi * R * R * R) == 200e3,
                 boost::test_tools::tolerance(1e-8));
      const auto points = model.compress(0.3);
      double last = 0.;
      for (const auto &point : points)
        {
          BOOST_TEST(std::abs(point.force_balance) < 1e-5); // Runge-Kutta, 400 steps
          BOOST_TEST(point.force >= last);
          last = point.force;
        }
      BOOST_TEST(points.back().pressure > 1.2 * 200e3);
      BOOST_TEST(std::abs(points.back().volume / points.front().volume - 1.) < 0.05);
    }
}

BOOST_AUTO_TEST_CASE(a_stiff_wall_less_balloon_is_a_drop)
{
  // Tension that hardly changes (stretched far, where T -> G t0) is a drop of surface tension G t0: for small squeezing
  // the force is p times the contact, and X - ... goes to zero with it.
  const BalloonModel model = balloon(BalloonModel::Membrane::neo_hookean, 200e3, 42e6);
  const auto points = model.compress(0.02);
  BOOST_TEST(points[1].deformation > 0.);
  BOOST_TEST(points[1].force == points[1].pressure * std::numbers::pi * std::pow(points[1].contact_radius, 2),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(points[1].deformation < 2e-3);
}

BOOST_AUTO_TEST_CASE(steps_converge_with_fourth_order)
{
  double force[3];
  for (int k = 0; k < 3; ++k)
    {
      BalloonModel model = balloon(BalloonModel::Membrane::net, 200e3, 42e6);
      model.steps = 25 << k;
      force[k] = BalloonModel::force_at(model.compress(0.15), 0.15);
    }
  const double order = std::log2(std::abs((force[0] - force[1]) / (force[1] - force[2])));
  BOOST_TEST_MESSAGE("forces " << force[0] << " " << force[1] << " " << force[2] << ", order " << order);
  BOOST_TEST(std::abs(force[2] / force[1] - 1.) < 1e-4);
}

BOOST_AUTO_TEST_SUITE_END()
