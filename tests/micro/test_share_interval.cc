// The interval of a share that was counted, by hand.
#include "micro/laws/share_interval.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_SUITE(share_interval)

/// (p + z^2/(2 n) -+ z sqrt(p (1 - p)/n + z^2/(4 n^2)))/(1 + z^2/n), z^2 = 3.8415
BOOST_AUTO_TEST_CASE(shares_by_hand) {
  // 60 of 100: (0.6 + 0.019207 -+ 1.96 sqrt(0.0024 + 0.000096))/1.038415
  BOOST_TEST(wilson_interval(60, 100).low == 0.5020, tt::tolerance(1e-3));
  BOOST_TEST(wilson_interval(60, 100).high == 0.6906, tt::tolerance(1e-3));
  // none of ten: from nothing to z^2/(n + z^2)
  BOOST_TEST(wilson_interval(0, 10).low == 0.);
  BOOST_TEST(wilson_interval(0, 10).high == 3.8415 / 13.8415, tt::tolerance(1e-4));
  BOOST_TEST(wilson_interval(10, 10).low == 10. / 13.8415, tt::tolerance(1e-4));
  BOOST_TEST(wilson_interval(10, 10).high == 1., tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
