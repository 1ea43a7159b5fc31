// The study's file: grids, axes, measures, references, escapes; its mistakes.
#include "app/csv_table.h"
#include "app/study_input.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(study)

namespace {
StudyInput study_of(const std::string &text) {
  const TemporaryDirectory directory;
  set_content(directory / "s.prm", text);
  set_content(directory / "curve.csv", "time [s],force [N]\n0,1\n1,2\n");
  std::filesystem::create_directory(directory / "old");
  set_content(directory / "old/probe.csv", "time [s],x [m]\n0,1\n1,2\n");
  return load_study(directory / "s.prm");
}

std::string study_error(const std::string &text) {
  try {
    study_of(text);
  } catch (const InputError &problem) {
    return problem.what();
  }
  return "";
}

std::vector<std::string> labels(const StudyInput &study) {
  std::vector<std::string> labels;
  for (const StudyRun &run : study.runs) labels.push_back(run.label);
  return labels;
}

const std::string run = "subsection Run a\nset Input = a.prm\nend\n";

std::string measure(const std::string &entries) { return run + "subsection Measure m\n" + entries + "end\n"; }
}  // namespace

BOOST_AUTO_TEST_CASE(runs_and_the_defaults_of_the_study) {
  const StudyInput study = study_of(
      "set Input = b.prm\nset Overrides = E=0\nset Threads = 2\nsubsection Run full\nset Input = "
      "../a.prm\nend\n"
      "subsection Run fine mesh\nset Method = FE2\nset Overrides = A/B=1; C=2; D = x\\; y;\nset Threads = "
      "3\nend\n");
  BOOST_REQUIRE(study.runs.size() == 2u);
  BOOST_TEST(study.runs[0].method == "full");
  BOOST_TEST(study.runs[0].input.filename() == "a.prm");
  BOOST_TEST(study.runs[0].threads == 2u);
  BOOST_TEST(study.runs[1].label == "fine mesh");
  BOOST_TEST(study.runs[1].method == "FE2");
  BOOST_TEST(study.runs[1].input.filename() == "b.prm");
  BOOST_TEST(study.runs[1].overrides == (std::vector<std::string>{"E=0", "A/B=1", "C=2", "D = x; y"}),
             boost::test_tools::per_element());
  BOOST_TEST(study.runs[1].threads == 3u);
  BOOST_TEST(!study.of_errors());
}

BOOST_AUTO_TEST_CASE(a_grid_is_every_combination_and_axes_are_one_at_a_time) {
  const StudyInput grid = study_of(
      "subsection Run g\nset Input = a.prm\nset Overrides = Z=1\nset Grid = A = 1 | 2; B/C & D = 3 & 4 | 5 & "
      "6\nend\n");
  BOOST_TEST(
      labels(grid) == (std::vector<std::string>{"g 1, 3 & 4", "g 1, 5 & 6", "g 2, 3 & 4", "g 2, 5 & 6"}),
      boost::test_tools::per_element());
  BOOST_TEST(grid.runs[3].overrides == (std::vector<std::string>{"Z=1", "A=2", "B/C=5", "D=6"}),
             boost::test_tools::per_element());
  BOOST_TEST(grid.runs[3].swept.size() == 3u);
  BOOST_TEST(grid.runs[3].swept[1].first == "B/C");
  const StudyInput axes =
      study_of("subsection Run g\nset Input = a.prm\nset Axes = A = 1 | 2; B/C & D = 3 & 4 | 5 & 6\nend\n");
  BOOST_TEST(labels(axes) == (std::vector<std::string>{"g A 1", "g A 2", "g B/C D 3 & 4", "g B/C D 5 & 6"}),
             boost::test_tools::per_element());
  BOOST_TEST(axes.runs[2].overrides == (std::vector<std::string>{"B/C=3", "D=4"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(separators_inside_values_are_escaped) {
  const StudyInput study =
      study_of("subsection Run g\nset Input = a.prm\nset Grid = F = 1, 0\\; 0, 1 | a\\|b | c & d\nend\n");
  BOOST_REQUIRE(study.runs.size() == 3u);
  BOOST_TEST(study.runs[0].overrides[0] == "F=1, 0; 0, 1");
  BOOST_TEST(study.runs[1].overrides[0] == "F=a|b");
  BOOST_TEST(study.runs[2].overrides[0] == "F=c & d");  // one entry: & is a letter like others
}

BOOST_AUTO_TEST_CASE(kinds_of_references) {
  using Kind = StudyReference::Kind;
  const auto kind = [](const std::string &entries) {
    return study_of(measure(entries)).measures[0].reference.kind;
  };
  const std::string force = "set Table = t\nset Columns = force\n";
  BOOST_TEST((kind(force) == Kind::none));
  BOOST_TEST((kind(force + "set Reference = a\n") == Kind::run));
  BOOST_TEST((kind(force + "set Reference = curve.csv\n") == Kind::file));
  BOOST_TEST((kind("set Table = probe\nset Columns = x\nset Reference = old\n") == Kind::directory));
  BOOST_TEST((kind(force + "set Reference = 2*sin(time/3)\n") == Kind::expression));
  BOOST_TEST((kind("set Result = pressure\nset Reference = 2e5\n") == Kind::expression));
  BOOST_TEST(study_of("set Reference = a\n" + measure(force)).of_errors());  // the study's own
}

BOOST_AUTO_TEST_CASE(what_is_drawn) {
  BOOST_TEST(study_of(run).draw_all);
  const StudyInput chosen = study_of("set Draw = p + q; r\n" + run);
  BOOST_TEST(!chosen.draw_all);
  BOOST_REQUIRE(chosen.draw.size() == 2u);
  BOOST_TEST(chosen.draw[0] == (std::vector<std::string>{"p", "q"}), boost::test_tools::per_element());
  BOOST_TEST(study_of("set Draw = none\n" + run).draw.empty());
}

BOOST_AUTO_TEST_CASE(mistakes_are_told_before_the_first_run) {
  const auto says = [](const std::string &text, const std::string &part) {
    const std::string said = study_error(text);
    BOOST_TEST(said.find(part) != std::string::npos, said);
  };
  const std::string force = "set Table = t\nset Columns = force\n",
                    both = "set Table = t\nset Columns = x, y\n";
  says("", "needs at least one");
  says(run + run, "there is a second subsection 'Run a'");
  says(run + "subsection Run b\nset Input = a.prm\nset Grid = A = 1 | 1\nend\n",
       "two runs with the label 'b 1'");
  says("subsection Rum a\nend\n", "'Run LABEL' and 'Measure NAME' only");
  says("subsection Run a\nend\n", "'Run a/Input' is missing");
  says("subsection Run a\nset Inpud = x\nend\n", "line 2: there is no entry 'Inpud'");
  says("subsection Run a\nset Threads = -1\nend\n", "a whole number from 0 to 1024");
  says("set Picture = stability\n" + run, "there is no entry 'Picture'");
  says("set Reference = a\n" + run, "no 'subsection Measure NAME'");
  for (const char *grid : {"A", "A =", "= 1 | 2", "A & B = 1 | 2", "A & B = 1 & 2 | 3"})
    says("subsection Run a\nset Input = a.prm\nset Grid = " + std::string(grid) + "\nend\n",
         "'Run a/Grid' holds '" + std::string(grid));
  says(measure("set Table = t\n"), "needs either 'Table' and 'Columns' or 'Result'");
  says(measure(force + "set Result = p\n"), "needs either 'Table' and 'Columns' or 'Result'");
  says(measure("set Result = p, q\n"), "one name");
  says(measure(force + "set Weight = median\n"), "one of rms, max, end, mean, largest, amplitude, period");
  says(measure(both + "set Weight = mean\n"), "is of one column; 'Columns' names 2");
  says(measure(force + "set Match = i\nset Weight = end\n"), "matched rows have no order");
  says(measure(force + "set Reference = 2*(time\n"), "no expression");
  says(measure(both + "set Reference = 2*time\n"), "one expression for each column");
  says(measure(both + "set Reference = curve.csv\n"), "has no column 'x'");
  says(measure(force + "set Reference = old\n"), "old/t.csv: No such file");
  says(measure("set Result = p\nset Reference = curve.csv\n"), "without 'Match', 'Parts' or a CSV");
}

BOOST_AUTO_TEST_CASE(the_printed_study_can_be_read) {
  const std::string text = study_parameters_text();
  BOOST_TEST(text.find("subsection Measure NAME") != std::string::npos);
  BOOST_TEST(study_error(text).find("'Run LABEL/Input' is missing") !=
             std::string::npos);  // nothing else is wrong with it
}

BOOST_AUTO_TEST_CASE(a_part_of_the_entries_of_a_study) {
  const std::string measure = study_parameters_text("Measure NAME"),
                    column = study_parameters_text("Measure NAME/Columns"),
                    top = study_parameters_text("Overrides");
  BOOST_TEST(measure.find("subsection Measure NAME") != std::string::npos);
  BOOST_TEST(measure.find("subsection Run LABEL") == std::string::npos);
  BOOST_TEST(column.find("set Columns") != std::string::npos);
  BOOST_TEST(column.find("set Match") == std::string::npos);
  BOOST_TEST(top.find("subsection") == std::string::npos);
  BOOST_CHECK_EXCEPTION(study_parameters_text("Measur NAME"), InputError, [](const InputError &e) {
    return std::string(e.what()).find("Did you mean 'Measure NAME'?") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(csv_mistakes) {
  const TemporaryDirectory directory;
  const std::string header = "time [s],displacement_x [m],displacement_y [m]\n";
  const auto table = [&](const std::string &text) {
    set_content(directory / "t.csv", text);
    return read_csv(directory / "t.csv");
  };
  BOOST_CHECK_EXCEPTION(table(header + "1,2\n"), std::runtime_error,
                        Says{"line 2: it has 2 fields where 3 are needed"});
  BOOST_CHECK_EXCEPTION(table(header + "1,2,x\n"), std::runtime_error,
                        Says{"holds 'x' where a finite number is expected"});
  BOOST_CHECK_EXCEPTION(table(header).column("displacement_z"), std::runtime_error,
                        Says{"Did you mean 'displacement_"});
  BOOST_TEST(table(header).units[1] == "m");
  BOOST_TEST(csv_field("a, \"b\"") == "\"a, \"\"b\"\"\"");
  BOOST_TEST(csv_of({{{"a", "1"}, {"b", "x,y"}}, {{"c", "3"}, {"a", "2"}}}) == "a,b,c\n1,\"x,y\",\n2,,3\n");
}

BOOST_AUTO_TEST_SUITE_END()
