// What a study measures: values and errors found by hand, closed forms, the first swing.
#include "app/expression.h"
#include "app/first_swing.h"
#include "app/study_measure.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(study_measure)

namespace {
/// Two finished runs whose tables are given; the second is the reference where the measure asks for a run.
struct TwoRuns {
  TemporaryDirectory directory;
  StudyMeasure asked;

  TwoRuns() {
    for (const char *name : {"run", "reference"}) std::filesystem::create_directory(directory / name);
    set_content(directory / "run/summary.json",
                R"({"results": {"p": {"value": 2.2, "unit": "Pa"}, "exact": {"value": 2.0, "unit": "Pa"}}})");
    set_content(directory / "reference/summary.json", R"({"results": {"p": {"value": 2.5, "unit": "Pa"}}})");
    asked.name = "m";
    asked.table = "t";
    asked.columns = {"x", "y"};
    asked.reference = {StudyReference::Kind::run, "reference", {}};
  }

  MeasuredRun of(const std::string &run, const std::string &reference,
                 const std::string &header = "time [s],x [m],y [m]\n") {
    set_content(directory / "run/t.csv", header + run);
    set_content(directory / "reference/t.csv", header + reference);
    return measure(asked, directory / "run", directory / "reference");
  }

  MeasuredRun against(const std::string &expression, const std::string &run,
                      const std::string &header = "time [s],x [m]\n") {
    asked.columns = {"x"};
    asked.reference = {StudyReference::Kind::expression, expression, {}};
    return of(run, "", header);
  }
};

const auto close = boost::test_tools::tolerance(1e-14);
}  // namespace

BOOST_AUTO_TEST_CASE(root_of_the_mean_square) {
  TwoRuns runs;
  // u_ref = (0, 2) throughout, u = (0, 2.2): ten per cent. The run's own times do not matter.
  BOOST_TEST(*runs.of("0,0,2.2\n1,0,2.2\n", "0,0,2\n0.5,0,2\n1,0,2\n").error == 0.1, close);
  BOOST_TEST(runs.of("0,0,2.2\n1,0,2.2\n", "0,0,2\n1,0,2\n").value == 2.2, close);
  BOOST_TEST(runs.of("0,0,2.2\n1,0,2.2\n", "0,0,2\n1,0,2\n").unit == "m");
  // An error of 1 in x at t = 0 falling linearly to 0 at 1, trapezoids at 0, 0.5, 1:
  // (1/4) (1 + 0.25) + (1/4) (0.25 + 0) = 0.375; the norm is 4
  BOOST_TEST(*runs.of("0,1,2\n1,0,2\n", "0,0,2\n0.5,0,2\n1,0,2\n").error == std::sqrt(0.375 / 4.), close);
  // In the unit of the columns.
  runs.asked.size = 1.;
  BOOST_TEST(*runs.of("0,1,2\n1,0,2\n", "0,0,2\n0.5,0,2\n1,0,2\n").error == std::sqrt(0.375), close);
  runs.asked.size = 0.;
  BOOST_CHECK_EXCEPTION(runs.of("0,1,2\n1,0,2\n", "0,0,0\n1,0,0\n"), std::runtime_error,
                        Says{"'Relative to' gives a size"});
}

BOOST_AUTO_TEST_CASE(largest_and_last) {
  TwoRuns runs;
  runs.asked.weight = Weight::max;
  BOOST_TEST(*runs.of("0,0,1\n1,0.3,4.4\n2,0,0\n", "0,0,1\n1,0,4\n2,0,0\n").error == 0.5 / 4., close);
  runs.asked.weight = Weight::end;
  BOOST_TEST(*runs.of("0,9,9\n2,3,5\n", "0,0,0\n2,3,4\n").error == 0.2, close);
  runs.asked.columns = {"y"};
  BOOST_TEST(runs.of("0,9,9\n2,3,-5\n", "0,0,0\n2,3,-4\n").value == -5.);
}

BOOST_AUTO_TEST_CASE(an_abscissa_that_falls_is_one_as_well) {
  TwoRuns runs;
  runs.asked.columns = {"y"};
  runs.asked.against = "x";
  // y = 1 - x of the run over x from 1 to 0.8, the reference twice as much: half of it is missing.
  const std::string run = "0,1,0\n1,0.9,0.1\n2,0.8,0.2\n";
  BOOST_TEST(*runs.of(run, "0,1,0\n1,0.8,0.4\n").error == 0.5, close);
  // A reference in the order of a rising abscissa is the same one.
  BOOST_TEST(*runs.of(run, "0,0.8,0.4\n1,1,0\n").error == 0.5, close);
  runs.asked.weight = Weight::end;
  BOOST_TEST(*runs.of(run, "0,0.8,0.4\n1,1,0\n").error == 0.5, close);
  BOOST_TEST(runs.of(run, "0,0.8,0.4\n1,1,0\n").value == 0.2, close);
  BOOST_CHECK_EXCEPTION(runs.of(run, "0,1,0\n1,0.5,0.4\n"), std::runtime_error,
                        Says{"covers 1 to 0.8, the reference 1 to 0.5"});
  BOOST_CHECK_EXCEPTION(runs.of("0,1,0\n1,0.8,0.1\n2,0.9,0\n", "0,1,0\n1,0.8,0.4\n"), std::runtime_error,
                        Says{"a column that rises or falls all the way"});
}

BOOST_AUTO_TEST_CASE(one_number_of_a_curve_has_a_sign) {
  TwoRuns runs;
  runs.asked.columns = {"y"};
  runs.asked.weight = Weight::mean;  // 1 + 3 of 4 s, against 2
  BOOST_TEST(*runs.of("0,0,1\n1,0,1\n1,0,3\n4,0,3\n", "0,0,2\n4,0,2\n").error == 0.25, close);
  runs.asked.weight = Weight::largest;
  BOOST_TEST(*runs.of("0,0,1\n2,0,-9\n", "0,0,2\n2,0,1\n").error == -0.5, close);
  BOOST_CHECK_EXCEPTION(runs.of("0,0,1\n1,0,1\n", "0,0,2\n4,0,2\n"), std::runtime_error,
                        Says{"covers 0 to 1, the reference 0 to 4"});
  runs.asked.weight = Weight::period;
  BOOST_CHECK_EXCEPTION(runs.of("0,0,0\n1,0,2\n2,0,1.9\n", "0,0,0\n1,0,2\n2,0,1.9\n"), std::runtime_error,
                        Says{"before the first swing is back"});
}

// A ringing about the reference of zero mean over every part is no error.
BOOST_AUTO_TEST_CASE(means_over_parts) {
  TwoRuns runs;
  runs.asked.columns = {"x"};
  std::string ringing, smooth;
  for (int k = 0; k <= 40; ++k) {
    const std::string t = std::to_string(0.1 * k);
    ringing += t + "," + std::to_string(0.1 * k + (k % 4 == 1 ? 1 : k % 4 == 3 ? -1 : 0)) + ",0\n";
    smooth += t + "," + t + ",0\n";
  }
  BOOST_TEST(*runs.of(ringing, smooth).error > 0.2);
  runs.asked.parts = 10;  // of 0.4 s, a period of the ringing
  BOOST_TEST(*runs.of(ringing, smooth).error < 1e-14);
}

BOOST_AUTO_TEST_CASE(rows_are_matched_by_their_names) {
  TwoRuns runs;
  const std::string header = "i,j,x [m],y [m]\n";
  runs.asked.match = {"i", "j"};
  // rows in another order; one off by (0, 0.5): 0.5 / 5
  BOOST_TEST(*runs.of("1,0,0,4.5\n0,0,3,0\n", "0,0,3,0\n1,0,0,4\n", header).error == 0.1, close);
  BOOST_CHECK_EXCEPTION(runs.of("1,0,0,4\n", "0,0,3,0\n1,0,0,4\n", header), std::runtime_error,
                        Says{"lacks the row (0, 0)"});
}

BOOST_AUTO_TEST_CASE(closed_forms_of_columns_and_results) {
  TwoRuns runs;
  BOOST_TEST(*runs.against("exact*time", "0,0\n1,2\n2,4\n").error == 0.);  // exact = 2, a result of the run
  BOOST_TEST(*runs.against("2*z", "0,2.2,1\n1,2.2,1\n", "time [s],x [m],z [m]\n").error == 0.1, close);
  BOOST_CHECK_EXCEPTION(runs.against("exakt*time", "0,0\n1,2\n"), std::runtime_error,
                        Says{"Did you mean 'exact'?"});
  runs.asked.table = "";
  runs.asked.columns = {"p"};
  runs.asked.reference.text = "exact";
  const MeasuredRun result = measure(runs.asked, runs.directory / "run", {});
  BOOST_TEST(result.value == 2.2);
  BOOST_TEST(result.unit == "Pa");
  BOOST_TEST(*result.error == 0.1, close);
  runs.asked.reference = {StudyReference::Kind::run, "reference", {}};
  BOOST_TEST(
      *measure(runs.asked, runs.directory / "run", runs.directory / "reference").error == 2.2 / 2.5 - 1.,
      close);
  runs.asked.reference = {};
  BOOST_TEST(!measure(runs.asked, runs.directory / "run", {}).error.has_value());
}

BOOST_AUTO_TEST_CASE(what_is_not_there_is_named) {
  TwoRuns runs;
  runs.asked.columns = {"w"};
  BOOST_CHECK_EXCEPTION(runs.of("0,0,1\n", "0,0,1\n"), std::runtime_error, Says{"has no column 'w'"});
  runs.asked.columns = {"x"};
  BOOST_CHECK_EXCEPTION(runs.of("0,0,1\n1,0,1\n0.5,0,1\n", "0,0,1\n"), std::runtime_error, Says{"'time' of"});
  runs.asked.table = "u";
  BOOST_CHECK_EXCEPTION(runs.of("0,0,1\n", "0,0,1\n"), std::runtime_error, Says{"u.csv: No such file"});
}

BOOST_AUTO_TEST_CASE(a_reference_is_read_in_its_own_units) {
  TwoRuns runs;
  runs.asked.columns = {"x"};
  set_content(runs.directory / "run/t.csv", "time [s],x [N]\n0,2.2\n4e-6,2.2\n");
  const auto against = [&](const std::string &header, const std::string &rows) {
    set_content(runs.directory / "mine.csv", header + rows);
    runs.asked.reference = {StudyReference::Kind::file, "mine.csv", runs.directory / "mine.csv"};
    return measure(runs.asked, runs.directory / "run", {});
  };
  BOOST_TEST(*against("time [us],x [mN]\n", "0,2000\n4,2000\n").error == 0.1, close);
  BOOST_TEST(*against("x[kN], time [ s ]\n", "0.002,0\n0.002,4e-6\n").error == 0.1,
             close);  // the abscissa is the run's, not its first column
  BOOST_CHECK_EXCEPTION(against("time [s],x [mPa]\n", "0,2\n4,2\n"), std::runtime_error,
                        Says{"'x' has the unit [mPa] in"});
  BOOST_CHECK_EXCEPTION(against("time [s],x\n", "0,2\n4,2\n"), std::runtime_error,
                        Says{"its header line names it: 'x [N]'"});
  BOOST_CHECK_EXCEPTION(against("time [m],x [N]\n", "0,2\n4,2\n"), std::runtime_error,
                        Says{"and the unit [s] in"});
}

BOOST_AUTO_TEST_CASE(expressions) {
  const auto none = [](const std::string &) -> double { throw std::logic_error("no variable was expected"); };
  BOOST_TEST(Expression("2^3 + sqrt(16)*sin(pi/2)")(none) == 12., close);
  BOOST_TEST(Expression("a*b + a").variables() == (std::vector<std::string>{"a", "b"}),
             boost::test_tools::per_element());
  BOOST_TEST(Expression("a*b + a")([](const std::string &name) { return name == "a" ? 2. : 5.; }) == 12.);
  for (const char *wrong : {"", "2*(a", "sin()", "a b", "2 +"})
    BOOST_CHECK_THROW(Expression{wrong}, std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(swing_by_hand) {
  // u = -(1 - cos(2 pi t / 0.8)): -2 at 0.4, back at 0.8, sampled where neither falls on a sample. A second
  // swing, a little larger, is not the first.
  for (const double larger : {1., 1.001}) {
    std::vector<double> t, u;
    for (int k = 0; k <= (larger > 1. ? 80 : 33); ++k) {
      t.push_back(0.03 * k);
      u.push_back((t.back() > 0.8 ? larger : 1.) * (std::cos(2. * M_PI * t.back() / 0.8) - 1.));
    }
    const Swing swing = first_swing(t, u);
    BOOST_TEST(std::abs(swing.amplitude + 2.) < 1e-3);
    BOOST_TEST(std::abs(swing.time_of_largest - 0.4) < 1e-3);
    BOOST_REQUIRE(swing.period.has_value());
    BOOST_TEST(std::abs(*swing.period - 0.8) < 1e-3);
  }
  // A history that ends on its way back has no period; one at rest no swing.
  BOOST_TEST(!first_swing({0., 1., 2.}, {0., 2., 1.5}).period.has_value());
  BOOST_CHECK_EXCEPTION(first_swing({0., 1., 2.}, {0., 0., 0.}), std::runtime_error, Says{"nothing moves"});
}

BOOST_AUTO_TEST_SUITE_END()
