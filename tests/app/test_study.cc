// The study: errors with values found by hand, the study file's mistakes, CSV fields.
#include "app/study_errors.h"
#include "app/study_input.h"
#include "app/swing.h"
#include "micro/io/run_context.h"
#include "tests/app/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(study)

namespace
{
CsvTable table(const TemporaryDirectory &directory, const std::string &text)
{
  set_content(directory / "t.csv", text);
  return read_csv(directory / "t.csv");
}
const std::string header = "time [s],displacement_x [m],displacement_y [m]\n";
const std::string cell_header = "cell_x,cell_y,displacement_x [m],displacement_y [m]\n";

std::string study_error(const std::string &text)
{
  const TemporaryDirectory directory;
  set_content(directory / "s.prm", text);
  try
    {
      load_study(directory / "s.prm");
    }
  catch (const InputError &problem)
    {
      return problem.what();
    }
  return "";
}
} // namespace

BOOST_AUTO_TEST_CASE(history_error_by_hand)
{
  const TemporaryDirectory directory;
  // u_ref = (0, 2) throughout, u = (0, 2.2): ten per cent. The run's own times do not matter.
  const CsvTable reference = table(directory, header + "0,0,2\n0.5,0,2\n1,0,2\n");
  BOOST_TEST(history_error(table(directory, header + "0,0,2.2\n1,0,2.2\n"), reference) == 0.1, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(history_error(reference, reference) == 0.);
  // An error of 1 in x at t = 0 falling linearly to 0 at 1, trapezoids at 0, 0.5, 1:
  // (1/4) (1 + 0.25) + (1/4) (0.25 + 0) = 0.375; the norm is 4
  BOOST_TEST(history_error(table(directory, header + "0,1,2\n1,0,2\n"), reference) == std::sqrt(0.375 / 4.),
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(swing_by_hand)
{
  const TemporaryDirectory directory;
  // u_y = -(1 - cos(2 pi t / 0.8)): -2 at 0.4, back at 0.8, sampled where neither falls on a sample.
  std::string text = header;
  for (int k = 0; k <= 33; ++k)
    {
      const double t = 0.03 * k;
      text += std::to_string(t) + ",0.1," + std::to_string(std::cos(2. * M_PI * t / 0.8) - 1.) + "\n";
    }
  const Swing swing = first_swing(table(directory, text));
  BOOST_TEST(std::abs(swing.amplitude + 2.) < 1e-3);
  BOOST_TEST(std::abs(swing.time_of_largest - 0.4) < 1e-3);
  BOOST_REQUIRE(swing.period.has_value());
  BOOST_TEST(std::abs(*swing.period - 0.8) < 1e-3);
  // A second swing, a little larger, is not the first.
  std::string twice = header;
  for (int k = 0; k <= 80; ++k)
    {
      const double t = 0.03 * k, grown = t > 0.8 ? 1.001 : 1.;
      twice += std::to_string(t) + ",0.1," + std::to_string(grown * (std::cos(2. * M_PI * t / 0.8) - 1.)) + "\n";
    }
  BOOST_TEST(std::abs(first_swing(table(directory, twice)).time_of_largest - 0.4) < 1e-3);
  BOOST_TEST(std::abs(*first_swing(table(directory, twice)).period - 0.8) < 1e-3);
  // A history that ends on its way back has no period; one at rest no swing.
  BOOST_TEST(!first_swing(table(directory, header + "0,0,0\n1,0,2\n2,0,1.5\n")).period.has_value());
  BOOST_CHECK_EXCEPTION(first_swing(table(directory, header + "0,0,0\n1,0,0\n2,0,0\n")), std::runtime_error, Says{"nothing moves"});
}

BOOST_AUTO_TEST_CASE(history_that_ends_early_is_refused)
{
  const TemporaryDirectory directory;
  const CsvTable reference = table(directory, header + "0,0,2\n1,0,2\n");
  BOOST_CHECK_EXCEPTION(history_error(table(directory, header + "0,0,2\n0.9,0,2\n"), reference), std::runtime_error, Says{"covers"});
  BOOST_TEST(history_error(table(directory, header + "0,0,2\n0.995,0,2\n"), reference) == 0.);
}

BOOST_AUTO_TEST_CASE(field_error_by_hand)
{
  const TemporaryDirectory directory;
  const CsvTable reference = table(directory, cell_header + "0,0,3,0\n1,0,0,4\n");
  // cells in another order; one cell off by (0, 0.5): 0.5 / 5
  BOOST_TEST(field_error(table(directory, cell_header + "1,0,0,4.5\n0,0,3,0\n"), reference) == 0.1,
             boost::test_tools::tolerance(1e-14));
  BOOST_CHECK_EXCEPTION(field_error(table(directory, cell_header + "1,0,0,4\n"), reference), std::runtime_error,
                        Says{"lacks cell (0, 0)"});
}

BOOST_AUTO_TEST_CASE(csv_mistakes)
{
  const TemporaryDirectory directory;
  BOOST_CHECK_EXCEPTION(table(directory, header + "1,2\n"), std::runtime_error, Says{"line 2: it has 2 fields where 3 are needed"});
  BOOST_CHECK_EXCEPTION(table(directory, header + "1,2,x\n"), std::runtime_error, Says{"holds 'x' where a finite number is expected"});
  BOOST_CHECK_EXCEPTION(table(directory, header).column("tip"), std::runtime_error, Says{"has no column 'tip'"});
  BOOST_TEST(csv_field("a, \"b\"") == "\"a, \"\"b\"\"\"");
}

BOOST_AUTO_TEST_CASE(study_file)
{
  const TemporaryDirectory directory;
  set_content(directory / "s.prm", "set Reference = full\nsubsection Run full\nset Input = ../a.prm\nend\n"
                                   "subsection Run fine mesh\nset Input = b.prm\nset Method = FE2\n"
                                   "set Overrides = A/B=1; C=2\nset Threads = 2\nend\n");
  const StudyInput input = load_study(directory / "s.prm");
  BOOST_TEST(input.reference == "full");
  BOOST_REQUIRE(input.runs.size() == 2u);
  BOOST_TEST(input.runs[0].method == "full");
  BOOST_TEST(input.runs[1].label == "fine mesh");
  BOOST_TEST(input.runs[1].input == directory.path / "b.prm");
  BOOST_TEST(input.runs[1].overrides == (std::vector<std::string>{"A/B=1", "C=2"}), boost::test_tools::per_element());
  BOOST_TEST(input.runs[1].threads == 2u);
}

BOOST_AUTO_TEST_CASE(study_file_mistakes)
{
  const std::string run = "subsection Run a\nset Input = a.prm\nend\n";
  BOOST_TEST(study_error("").find("needs at least one") != std::string::npos);
  BOOST_TEST(study_error(run).find("'Reference' is missing") != std::string::npos);
  BOOST_TEST(study_error("set Reference = b\n" + run).find("neither a run of this study") != std::string::npos);
  BOOST_TEST(study_error("set Reference = a\n" + run + run).find("two runs with the label 'a'") != std::string::npos);
  BOOST_TEST(study_error("subsection Rum a\nend\n").find("'Run LABEL' only") != std::string::npos);
  BOOST_TEST(study_error("set Reference = a\nsubsection Run a\nend\n").find("'Run a/Input' is missing") != std::string::npos);
  BOOST_TEST(study_error("subsection Run a\nset Inpud = x\nend\n").find("line 2: there is no entry 'Inpud'") != std::string::npos);
  BOOST_TEST(study_error("subsection Run a\nset Threads = 0\nend\n").find("a whole number from 1 to 1024") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
