// The validation's table: values and verdicts by hand, the file's mistakes, the marks in the document, studies of results.
#include "app/study_input.h"
#include "app/validation_table.h"
#include "micro/io/run_context.h"
#include "tests/app/temporary_directory.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(validation)

namespace
{
std::string error_of(const std::string &json)
{
  const TemporaryDirectory directory;
  set_content(directory / "a.json", json);
  try
    {
      load_validations((directory / "a.json").parent_path());
    }
  catch (const InputError &problem)
    {
      return problem.what();
    }
  return "";
}
const std::string runs = R"("runs": {"": {"input": "x.prm"}})";
} // namespace

BOOST_AUTO_TEST_CASE(values_and_verdicts_by_hand)
{
  const TemporaryDirectory directory;
  set_content(directory / "summary.json", R"({"results": {"p": {"value": 2.02, "unit": "Pa"}, "exact": {"value": 2.0, "unit": "Pa"}}})");
  const std::map<std::string, std::filesystem::path> runs_at = {{"", (directory / "summary.json").parent_path()}, {"two", (directory / "summary.json").parent_path()}};
  ValidationRow row;
  row.result = "p";
  row.relative_to = "two:exact";
  row.most = 1.1;
  BOOST_TEST(value_of(row, runs_at) == 1., boost::test_tools::tolerance(1e-12)); // 100 (2.02/2 - 1) %
  BOOST_TEST(verdict_of(row, -1.0) == "met");
  BOOST_TEST(verdict_of(row, -1.2) == "missed");
  row.relative_to = "4.04";
  BOOST_TEST(value_of(row, runs_at) == -50., boost::test_tools::tolerance(1e-12));
  row.relative_to = "";
  row.scale = 10.;
  row.least = 20.;
  row.most = 20.3;
  BOOST_TEST(value_of(row, runs_at) == 20.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(verdict_of(row, 20.2) == "met");
  BOOST_TEST(verdict_of(row, 19.9) == "missed");
  row.least.reset();
  row.most.reset();
  BOOST_TEST(verdict_of(row, 1.) == "reported");
  row.result = "q";
  BOOST_CHECK_THROW(value_of(row, runs_at), std::runtime_error);
  row.result = "three:p";
  BOOST_CHECK_THROW(value_of(row, runs_at), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(the_table_goes_between_its_marks)
{
  const std::string once = with_table("# Head\n", "| a |\n");
  BOOST_TEST(once.find("# Head\n") == 0u);
  const std::string twice = with_table(once + "\nbehind\n", "| b |\n");
  BOOST_TEST(twice.find("| a |") == std::string::npos);
  BOOST_TEST(twice.find("| b |") != std::string::npos);
  BOOST_TEST(twice.find("\nbehind\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(results_survive_the_file)
{
  const TemporaryDirectory directory;
  write_results(directory / "r.csv", {{"name", "a \"quantity\", with a comma", "1.5", "%", "3", "met"}});
  const std::vector<ValidationResult> back = read_results(directory / "r.csv");
  BOOST_REQUIRE(back.size() == 1u);
  BOOST_TEST(back[0].quantity == "a \"quantity\", with a comma");
  BOOST_TEST(back[0].verdict == "met");
  BOOST_TEST(read_results(directory / "none.csv").empty());
}

BOOST_AUTO_TEST_CASE(mistakes_are_named)
{
  const auto has = [](const std::string &text, const std::string &part) { return text.find(part) != std::string::npos; };
  BOOST_TEST(has(error_of("{" + runs + R"(, "rows": [{"quantitie": "x"}]})"), "Did you mean 'quantity'?"));
  BOOST_TEST(has(error_of("{" + runs + "}"), "at least one of 'runs' and one of 'rows'"));
  BOOST_TEST(has(error_of("{" + runs + R"(, "rows": [{"quantity": "x", "source": "y"}]})"), "'result' is missing"));
  BOOST_TEST(has(error_of("{" + runs + R"(, "rows": [{"quantity": "x", "source": "y", "result": "p", "relative_to": "q", "unit": "Pa"}]})"), "is in %"));
  const std::string row = R"({"quantity": "x", "source": "y", "result": "p"})";
  BOOST_TEST(has(error_of("{" + runs + ", \"rows\": [" + row + ", " + row + "]}"), "a quantity needs a name of its own"));
  BOOST_TEST(has(error_of("{"), "a.json"));
}

BOOST_AUTO_TEST_CASE(an_axis_is_one_run_a_value)
{
  const TemporaryDirectory directory;
  set_content(directory / "s.prm", "set Picture = p\nsubsection Axis wall\n set Input = a.prm\n set Overrides = B=2\n set Entry = A\n set Values = 1 | 10\nend\n");
  const StudyInput study = load_study(directory / "s.prm");
  BOOST_TEST(!study.of_errors());
  BOOST_REQUIRE(study.runs.size() == 2u);
  BOOST_TEST(study.runs[1].label == "wall 10");
  BOOST_TEST(study.runs[1].method == "wall");
  BOOST_REQUIRE(study.runs[1].overrides.size() == 2u);
  BOOST_TEST(study.runs[1].overrides[1] == "A=10");
  set_content(directory / "t.prm", "set Picture = p\nsubsection Axis wall\n set Input = a.prm\n set Entry = A\nend\n");
  BOOST_CHECK_THROW(load_study(directory / "t.prm"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
