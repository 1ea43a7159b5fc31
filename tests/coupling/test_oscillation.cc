#include "coupling/oscillation.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using turgor::Oscillation;

BOOST_AUTO_TEST_SUITE(oscillation)

// y = 1 - exp(-d t) cos(w t): y' = 0 where tan(w t) = -d/w.
BOOST_AUTO_TEST_CASE(damped_swing_by_hand) {
  const double w = 2. * M_PI / 0.47e-3, d = 500.;
  Oscillation o;
  double t = 0.;
  for (int k = 0; t < 0.6e-3; ++k) {
    o.add(t, 1. - std::exp(-d * t) * std::cos(w * t));
    t += k % 2 == 0 ? 0.8e-6 : 1.1e-6;  // unequal steps
  }
  BOOST_TEST_REQUIRE(o.has_maximum());
  BOOST_TEST_REQUIRE(o.has_return());
  const double first = (M_PI - std::atan(d / w)) / w, second = first + M_PI / w;
  BOOST_TEST(o.maximum().time == first, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(o.minimum().time == second, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(o.maximum().value == 1. - std::exp(-d * first) * std::cos(w * first),
             boost::test_tools::tolerance(1e-7));
  BOOST_TEST(o.minimum().value == 1. - std::exp(-d * second) * std::cos(w * second),
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(small_wiggles_do_not_count) {
  Oscillation o;
  for (double t = 0.; t < 0.75; t += 0.001)  // not yet fallen by half a per cent
    o.add(t, std::sin(2. * t) + 0.001 * std::sin(300. * t));
  BOOST_TEST(!o.has_maximum());
  BOOST_TEST(o.maximum().value == 1., boost::test_tools::tolerance(0.01));
  for (double t = 0.75; t < 1.2; t += 0.001) o.add(t, std::sin(2. * t) + 0.001 * std::sin(300. * t));
  BOOST_TEST(o.has_maximum());
  BOOST_TEST(!o.has_return());
}

BOOST_AUTO_TEST_SUITE_END()
