// What is wrong with a state, and with which particle.
#include "micro/engine/sound_state.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(sound_state)

BOOST_AUTO_TEST_CASE(the_first_particle_that_means_nothing_is_named) {
  Particles<2> p;
  p.resize(6);
  p.groups = {{0, 2, 3}, {3, 5, 6}};
  BOOST_TEST(unsound(p).empty());
  const SoundBounds bounds{.reach = 10., .fastest = 5., .cell = in_columns(1)};
  p.x[0][4] = -10.;
  BOOST_TEST(unsound(p).empty());
  BOOST_TEST(unsound(p, bounds) == "a wall node of cell (0, 1) has left the scene, to (-10, 0) m");
  p.x[0][4] = 9.;
  p.v[0][5] = 3.;
  BOOST_TEST(unsound(p, bounds).empty());
  p.v[1][5] = -4.;
  BOOST_TEST(unsound(p, bounds) ==
             "a fluid particle of cell (0, 1) moves at 5 m/s, more than the 5 m/s up to which it would mean "
             "something");
  p.f[1][2] = std::nan("");
  BOOST_TEST(unsound(p, bounds) ==
             "a fluid particle of cell (0, 0) has a position, velocity or force that is no number any more");
  BOOST_TEST(unsound(p) == "a fluid particle has a position, velocity or force that is no number any more");
}

BOOST_AUTO_TEST_SUITE_END()
