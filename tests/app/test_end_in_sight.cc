// A run with no end in sight says so once, a slow beginning or a slow run that ends says nothing.
#include "run/end_in_sight.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(end_in_sight)

namespace {
/// Sentences of a run whose share grows by `pace(seconds)` a second, two steps a second, for so many seconds.
template <class Pace>
std::vector<std::string> told(const double seconds, const Pace &pace) {
  EndInSight sight;
  std::vector<std::string> all;
  double share = 0.;
  for (double t = 0.5; t <= seconds; t += 0.5) {
    share += 0.5 * pace(t);
    if (const std::string one = sight.after_step(share, t); !one.empty()) all.push_back(one);
  }
  return all;
}
}  // namespace

BOOST_AUTO_TEST_CASE(says_once_how_many_steps_are_left) {
  const std::vector<std::string> all = told(100., [](double) { return 1e-10; });
  BOOST_REQUIRE(all.size() == 1u);
  BOOST_TEST(
      all[0] ==
      "no end is in sight: the steps are so short that about 2e+10 more of them are left, more than two "
      "weeks at this pace");
  BOOST_TEST(told(100., [](double) { return 0.; }).at(0).find("countless") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(says_nothing_of_a_run_that_ends) {
  BOOST_TEST(told(1000., [](double) { return 1. / (13. * 86400.); }).empty());  // within 13 days
  BOOST_TEST(told(100., [](double t) { return t < 12. ? 1e-12 : 1e-3; }).empty());
}

BOOST_AUTO_TEST_SUITE_END()
