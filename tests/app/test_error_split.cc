// The split of an error into its parts, by hand: which rests are remarked upon, and for what reason.
#include "app/error_split.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;

namespace {
Counterpart sixteen_cells() {
  Counterpart cells{"static_lattice", {{"Columns", "16"}, {"Rows", "16"}}, false, false, {}, {}};
  cells.half = {{"Columns", "8"}, {"Rows", "8"}};
  cells.refinements.emplace_back("mesh", Counterpart::Entries{});
  return cells;
}

/// FE2 with its mesh at 1.01 of the finer one, 16 cells and 8 cells.
ErrorSplit split_of(const double finer, const double sixteen, const double eight) {
  std::map<std::string, Compared> runs;
  runs[as_it_is].values["tip"] = 1.01 * finer;
  runs[refined_label + std::string("mesh")].values["tip"] = finer;
  runs[all_cells].values["tip"] = sixteen;
  runs[fewer_cells].values["tip"] = eight;
  return error_split(sixteen_cells(), runs);
}

bool says(const ErrorSplit &split, const std::string &words) {
  return split.remarks.contains("tip") && split.remarks.at("tip").find(words) != std::string::npos;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(ErrorSplits)

// f = L (1 + a/n) is what the number's part is made for: nothing is left.
BOOST_AUTO_TEST_CASE(what_goes_with_one_over_n_leaves_no_rest) {
  const ErrorSplit split = split_of(1., 1. - 0.8 / 16, 1. - 0.8 / 8);
  BOOST_REQUIRE_EQUAL(split.lines.size(), 5);  // total, mesh, number, rest, all cells
  BOOST_TEST(split.lines[0].share.at("tip") == 1.01 / 0.95 - 1.);
  BOOST_TEST(split.lines[1].share.at("tip") == 0.01, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(split.lines[2].share.at("tip") == 1. / 0.95 - 1., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(split.lines[3].share.at("tip")) < 1e-14);
  BOOST_TEST(split.remarks.empty());
}

// A course with a largest value: the frozen block of square cells at 8 and 16 (doc/results/error_split), +1.9
// and +2.6 %.
BOOST_AUTO_TEST_CASE(a_course_that_turns_is_not_explained) {
  const ErrorSplit split = split_of(1., 1.026, 1.019);
  BOOST_TEST(says(split, "more than 50 %: the split does not explain this error"));
  BOOST_TEST(says(split, "from 8 to 16 cells all cells move away from FE2"));
}

BOOST_AUTO_TEST_CASE(a_course_that_is_no_line_in_one_over_n_is_told) {
  const ErrorSplit faster = split_of(1., 1. + 8. / (16 * 16), 1. + 8. / (8 * 8));
  BOOST_TEST(says(faster, "faster than with 1/n"));
  const ErrorSplit slower = split_of(1., 1.04, 1.041);
  BOOST_TEST(says(slower, "more slowly than with 1/n"));
}

BOOST_AUTO_TEST_CASE(a_number_that_cannot_be_halved_is_told) {
  Counterpart cells = sixteen_cells();
  cells.half.clear();
  std::map<std::string, Compared> runs;
  runs[as_it_is].values["tip"] = runs[refined_label + std::string("mesh")].values["tip"] = 1.;
  runs[all_cells].values["tip"] = 0.9;
  const ErrorSplit split = error_split(cells, runs);
  BOOST_REQUIRE_EQUAL(split.lines.size(), 4);
  BOOST_TEST(says(split, "the rest is 100 % of the error"));
  BOOST_TEST(says(split, "16 by 16 cells cannot be halved"));
}

BOOST_AUTO_TEST_SUITE_END()
