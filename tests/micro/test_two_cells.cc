// The scene of two cells: pull-off found by the over-damped engine, hysteresis, bad input.
#include "micro/solve/bisection.h"
#include "run/input_entries.h"
#include "micro/scenes/instruments/two_cells.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;

namespace {
double result(const std::string &text, const std::string &name) {
  TwoCells scene;
  InputEntries prm;
  scene.declare_parameters(prm);
  prm.read(text);
  scene.check();
  test::Disk disk;
  test::MemoryContext context(disk, false);
  scene.run(context);
  return context.results.at(name);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(two_cells)

BOOST_AUTO_TEST_CASE(pull_off_is_found_by_moving_the_cells) {
  BOOST_CHECK_SMALL(result("set Law = jkr", "pull_off_error"), 1e-6);
  BOOST_CHECK_SMALL(result("set Law = extended_hertz", "pull_off_error"), 1e-6);
  BOOST_CHECK_SMALL(result("set Law = hertz", "hertz_force_error"),
                    1e-11);  // overlap is a small difference of radii
}

BOOST_AUTO_TEST_CASE(rest_is_judged_by_the_net_force) {
  // Where the medium's drag is nothing beside the friction between the cells, velocity says nothing about the
  // force that is left.
  for (const std::string gamma : {"1e-9", "2.6e-7"})
    for (const std::string law : {"jkr", "extended_hertz"})
      BOOST_CHECK_SMALL(result("set Law = " + law + "\nset Medium friction = " + gamma, "pull_off_error"),
                        1e-6);
  // a contact that holds beyond a fifth of the radius
  BOOST_CHECK_SMALL(result("set Adhesion = 3e-4", "pull_off_error"), 1e-6);
}

BOOST_AUTO_TEST_CASE(a_pair_that_holds_comes_to_rest) {
  // weak adhesion, whose place of rest lies below the overlap at the start, and cells of other sizes
  for (const std::string entry : {"Adhesion = 3e-5", "Adhesion = 1e-7", "Adhesion = 1e-10", "Radius = 7e-3",
                                  "Adhesion = 1e-10\nset Law = extended_hertz"})
    BOOST_CHECK_SMALL(result("set " + entry, "pull_off_error"), 1e-6);
}

BOOST_AUTO_TEST_CASE(a_search_without_end_says_what_helps) {
  const std::string soft = "set Modulus = 1e-3\nset Adhesion = 1e-12\nset Radius = 1\n";
  BOOST_CHECK_EXCEPTION(result(soft + "set Medium friction = 1e-12", "pull_off"), RunFailed,
                        [](const RunFailed &e) {
                          return std::string(e.what()).find("a larger Medium friction") != std::string::npos;
                        });
  BOOST_CHECK_SMALL(result(soft + "set Medium friction = 1", "pull_off_error"), 1e-6);
}

BOOST_AUTO_TEST_CASE(a_bracket_has_ends) {
  const auto below_two = [](const double x) { return x * x < 2.; };
  BOOST_TEST(bisect(1., 2., below_two, "a root") == std::sqrt(2.), boost::test_tools::tolerance(1e-15));
  for (const auto &[low, high] : {std::pair(1.5, 2.), std::pair(0., 1.)})
    BOOST_CHECK_EXCEPTION(bisect(low, high, below_two, "a root"), std::runtime_error,
                          [](const std::runtime_error &e) {
                            return std::string(e.what()).find("a root does not lie between") == 0;
                          });
}

BOOST_AUTO_TEST_CASE(only_jkr_loses_work_in_a_cycle) {
  const double jkr = result("set Law = jkr", "hysteresis_work"),
               hertz = result("set Law = hertz", "hysteresis_work");
  BOOST_TEST(jkr > 0.);
  BOOST_CHECK_SMALL(hertz, 1e-9 * jkr);
  BOOST_TEST(result("set Law = jkr", "momentum_imbalance") < 1e-13);
}

BOOST_AUTO_TEST_CASE(adhesion_has_to_suit_the_law) {
  BOOST_CHECK_EXCEPTION(
      result("set Law = jkr\nset Adhesion = 0", "pull_off"), InputError,
      [](const InputError &e) { return std::string(e.what()).find("Adhesion is 0") != std::string::npos; });
  BOOST_CHECK_THROW(result("set Adhesion = 1", "pull_off"), InputError);
}

// The least adhesion that the message names is enough, whatever the cells.
BOOST_AUTO_TEST_CASE(adhesion_that_drowns_in_round_off_is_refused) {
  for (const std::string cells :
       {"", "set Law = extended_hertz\n", "set Modulus = 1e12\n", "set Radius = 1e-3\nset Accuracy = 1e-9\n",
        "set Radius = 1e-9\nset Modulus = 1e-3\n"}) {
    std::string least;
    const auto names_it = [&](const InputError &e) {
      const std::string text = e.what();
      const std::string before = "Use at least ";
      const std::size_t at = text.find(before);
      if (at == std::string::npos) return false;
      least = text.substr(at + before.size());
      least = least.substr(0, least.find(','));
      return text.find("Adhesion is ") == 0;
    };
    for (const std::string none : {"5e-324", "1e-100", "1e-25"})
      BOOST_CHECK_EXCEPTION(result(cells + "set Adhesion = " + none, "pull_off"), InputError, names_it);
    const double error = result(cells + "set Adhesion = " + least, "pull_off_error");
    BOOST_TEST_MESSAGE(cells << "least adhesion " << least << ": error " << error);
    BOOST_CHECK_SMALL(error, 1e-6);
  }
}

// Where the cells let go between two rows of the curve, results of the curve mean nothing and are left out;
// between a few rows they are rough, and the advice makes them good.
BOOST_AUTO_TEST_CASE(a_curve_too_coarse_for_its_results_says_so) {
  const auto outcome = [](const std::string &text) {
    TwoCells scene;
    InputEntries prm;
    scene.declare_parameters(prm);
    prm.read(text);
    scene.check();
    test::Disk disk;
    test::MemoryContext context(disk, false);
    scene.run(context);
    return std::pair(context.results, context.notes);
  };
  const auto advised = [](const std::string &note) {
    const std::string before = "Use Samples = ";
    const std::size_t at = note.find(before);
    return at == std::string::npos
               ? "none"
               : note.substr(at + before.size(), note.find(" or more") - at - before.size());
  };
  const auto [fine, no_note] = outcome("");
  BOOST_TEST(fine.contains("hysteresis_work"));
  BOOST_TEST(!no_note.contains("hysteresis_work"));
  for (const auto &[few, told] : {std::pair("Adhesion = 1e-7", true), {"Adhesion = 1e-9", false}}) {
    const std::string entry = "set " + std::string(few) + "\n";
    const auto [results, notes] = outcome(entry);
    BOOST_TEST(results.contains("hysteresis_work") == told, few);
    BOOST_TEST(results.contains("largest_pull_of_the_curve") == told, few);
    BOOST_REQUIRE(notes.contains("hysteresis_work"));
    const auto [better, silent] = outcome(entry + "set Samples = " + advised(notes.at("hysteresis_work")));
    BOOST_TEST(!silent.contains("hysteresis_work"));
    BOOST_TEST(better.at("largest_pull_of_the_curve") == better.at("pull_off"),
               boost::test_tools::tolerance(0.01));
    BOOST_TEST(better.at("hysteresis_work") > 0.);
  }
}

BOOST_AUTO_TEST_SUITE_END()
