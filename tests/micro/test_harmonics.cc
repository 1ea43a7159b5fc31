// Frequencies of a short signal: three decaying cosines, alone and with noise, from two and a half periods of
// the lowest.
#include "micro/laws/counter_random.h"
#include "micro/scenes/reference/harmonics.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(harmonic_fit)

BOOST_AUTO_TEST_CASE(a_few_periods_give_the_frequencies) {
  const double omega[3] = {1., 1.9, 3.07}, decay[3] = {0.01, 0.03, 0.}, size[3] = {1., 0.3, 0.1}, dt = 0.1;
  for (const double noise : {0., 1e-3}) {
    std::vector<double> signal;
    for (int k = 0; k < 160; ++k) {
      double y = 0.2 + noise * (2. * random_uniform(3, k) - 1.);
      for (int m = 0; m < 3; ++m)
        y += size[m] * std::exp(-decay[m] * k * dt) * std::cos(omega[m] * k * dt + m);
      signal.push_back(y);
    }
    const std::vector<Harmonic> parts = harmonics(signal, dt, noise > 0. ? 8 : 3);
    BOOST_REQUIRE(parts.size() >= 3);
    for (int m = 0; m < 3; ++m) {
      const Harmonic part = largest_between(parts, omega[m] - 0.3, omega[m] + 0.3);
      BOOST_TEST_MESSAGE("noise " << noise << ": " << part.omega / omega[m] - 1. << ", amplitude "
                                  << part.amplitude);
      BOOST_TEST(std::abs(part.omega / omega[m] - 1.) < (noise > 0. ? 2e-3 : 1e-9));
      BOOST_TEST(std::abs(part.amplitude / size[m] - 1.) < (noise > 0. ? 0.05 : 1e-7));
    }
  }
  BOOST_TEST(largest_between({}, 0., 1.).omega == 0.);
  // a tenth a period is the most a mode may lose, or gain; the larger tone beside it loses more and is passed
  // over
  const double tenth = -std::log(0.9) / (2. * std::acos(-1.));
  const std::vector<Harmonic> tones = {{1., 1.01 * tenth, 5., 0.},
                                       {1.01, 0.99 * tenth, 1., 0.},
                                       {3., -2.1 * tenth, 1., 0.},
                                       {4., -4. * tenth, 1., 0.}};
  BOOST_TEST(largest_between(tones, 0.9, 1.1).amplitude == 1.);
  BOOST_TEST(largest_between(tones, 0.9, 1.005).omega == 0.);
  BOOST_TEST(largest_between(tones, 2.9, 3.1).omega == 3.);
  BOOST_TEST(largest_between(tones, 3.9, 4.1).omega == 0.);  // exp(0.105) - 1 = 0.111
  BOOST_CHECK_THROW(harmonics(std::vector<double>(10, 1.), dt, 3), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
