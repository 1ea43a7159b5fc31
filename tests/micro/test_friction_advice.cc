// Spheroids whose cells have too little friction: what is said, and whether the advice helps.
#include "micro/scenes/spheroid/spheroid_free.h"
#include "tests/micro/run_of_scene.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using test::run;

namespace {
std::string spheroid(const std::string &medium, const std::string &between, const std::string &method) {
  return "set First cells = 6\nset First phases = spread\nset End time = 600\nset Frames = 0\nset Samples = "
         "10\n"
         "set Checkpoints = 0\nsubsection Motion\n set Method = " +
         method + "\nend\nsubsection Contact\n set Medium friction = " + medium +
         "\n set Normal friction = " + between + "\n set Tangential friction = " + between + "\nend\n";
}

std::string why(const std::string &text) {
  try {
    run<SpheroidFree>(text);
  } catch (const RunFailed &failed) {
    return failed.what();
  }
  return "";
}

/// What stands behind these words, up to a blank, a comma or a full stop at a number's end.
std::string number_after(const std::string &text, const std::string &words) {
  const std::size_t at = text.find(words);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, text);
  std::string number = text.substr(at + words.size());
  number = number.substr(0, number.find_first_of(", "));
  if (number.ends_with('.')) number.pop_back();
  return number;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(friction_advice_of_spheroids)

BOOST_AUTO_TEST_CASE(cells_tied_far_more_firmly_than_held) {
  const std::string refused = why(spheroid("1e-3", "5e10", "euler"));
  BOOST_TEST_MESSAGE(refused);
  BOOST_TEST(refused.find("Contact/Medium friction is 0.001 N s/m^3: contacts tie cells") !=
             std::string::npos);
  const std::string medium = number_after(refused, "a Contact/Medium friction of at least "),
                    between = number_after(refused, "a Contact/Tangential friction of at most ");
  BOOST_TEST(why(spheroid(medium, "5e10", "euler")) == "");
  BOOST_TEST(why(spheroid("1e-3", between, "euler")) == "");
}

BOOST_AUTO_TEST_CASE(cells_that_nothing_holds) {
  for (const std::string method : {"euler", "heun", "implicit"}) {
    const std::string refused = why(spheroid("1e-3", "0", method));
    BOOST_TEST_MESSAGE(refused);
    BOOST_TEST(refused.find("too little friction for any step") != std::string::npos);
    BOOST_TEST(refused.find("Method") == std::string::npos);
    BOOST_TEST(why(spheroid(number_after(refused, "Use a Contact/Medium friction of about "), "0", method)) ==
               "");
  }
}

BOOST_AUTO_TEST_SUITE_END()
