// The validation's table: values and verdicts by hand, the file's mistakes, the marks in the document.
#include "app/validation_table.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(validation)

namespace {
std::string error_of(const std::string &json) {
  const TemporaryDirectory directory;
  set_content(directory / "a.json", json);
  try {
    load_validations((directory / "a.json").parent_path());
  } catch (const InputError &problem) {
    return problem.what();
  }
  return "";
}
const std::string runs = R"("runs": {"": {"input": "x.prm"}})";
}  // namespace

BOOST_AUTO_TEST_CASE(values_and_verdicts_by_hand) {
  const TemporaryDirectory directory;
  set_content(directory / "summary.json",
              R"({"results": {"p": {"value": 2.02, "unit": "Pa"}, "exact": {"value": 2.0, "unit": "Pa"}}})");
  const std::map<std::string, std::filesystem::path> runs_at = {
      {"", (directory / "summary.json").parent_path()}, {"two", (directory / "summary.json").parent_path()}};
  ValidationRow row;
  row.result = "p";
  row.relative_to = "two:exact";
  row.most = 1.1;
  BOOST_TEST(value_of(row, runs_at).value == 1., boost::test_tools::tolerance(1e-12));  // 100 (2.02/2 - 1) %
  BOOST_TEST(verdict_of(row, {-1.0}) == "met");
  BOOST_TEST(verdict_of(row, {-1.2}) == "missed");
  row.relative_to = "4.04";
  BOOST_TEST(value_of(row, runs_at).value == -50., boost::test_tools::tolerance(1e-12));
  row.relative_to = "";
  row.scale = 10.;
  row.least = 20.;
  row.most = 20.3;
  BOOST_TEST(value_of(row, runs_at).value == 20.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(verdict_of(row, {20.2}) == "met");
  BOOST_TEST(verdict_of(row, {19.9}) == "missed");
  row.least.reset();
  row.most.reset();
  BOOST_TEST(verdict_of(row, {1.}) == "reported");
  row.result = "q";
  BOOST_CHECK_THROW(value_of(row, runs_at), std::runtime_error);
  row.result = "three:p";
  BOOST_CHECK_THROW(value_of(row, runs_at), std::runtime_error);
}

// Means 2 and 4 of two runs each, standard errors 1 and 1: 100 (2/4 - 1) = -50 %, error 100 sqrt((1/4)^2 +
// (2/4 1/4)^2) = 28 %.
BOOST_AUTO_TEST_CASE(means_over_runs_have_a_standard_error) {
  const TemporaryDirectory directory;
  const auto at = [&](const std::string &name, const std::string &value) {
    std::filesystem::create_directory(directory / name);
    set_content(directory / name / "summary.json",
                R"({"results": {"p": {"value": )" + value + R"(, "unit": "Pa"}}})");
    return (directory / name / "summary.json").parent_path();
  };
  const std::map<std::string, std::filesystem::path> runs_at = {
      {"a 1", at("a1", "1")}, {"a 2", at("a2", "3")}, {"b 1", at("b1", "3")}, {"b 2", at("b2", "5")}};
  const std::map<std::string, std::vector<std::string>> means = {{"a", {"a 1", "a 2"}},
                                                                 {"b", {"b 1", "b 2"}}};
  ValidationRow row;
  row.result = "a:p";
  row.most = 10.;
  const Measured mean = value_of(row, runs_at, means);
  BOOST_TEST(mean.value == 2., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(mean.error == 1., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(in_digits(mean) == "2 +- 1");
  BOOST_TEST(verdict_of(row, mean) == "met");
  row.relative_to = "b:p";
  const Measured ratio = value_of(row, runs_at, means);
  BOOST_TEST(ratio.value == -50., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ratio.error == 100. * std::hypot(0.25, 0.125), boost::test_tools::tolerance(1e-14));
  row.least = -100.;
  row.most = -10.;
  BOOST_TEST(verdict_of(row, ratio) ==
             "within the scatter");  // 40 % from the end of the target, less than twice 28 %
  row.most = 20.;
  row.least = -150.;
  BOOST_TEST(verdict_of(row, ratio) == "met");
  row.most = -120.;
  BOOST_TEST(verdict_of(row, ratio) == "missed");
  row.result = "c:p";
  BOOST_CHECK_THROW(value_of(row, runs_at, means), std::runtime_error);
  auto lacking = means;
  lacking["a"].push_back("a 3");  // one run did not finish: no mean of the others
  row.result = "a:p";
  BOOST_CHECK_THROW(value_of(row, runs_at, lacking), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(a_run_for_each_value) {
  const TemporaryDirectory directory;
  set_content(
      directory / "a.json",
      R"({"runs": {"dense": {"input": "x.prm", "overrides": ["B=2"], "each": "Tissue seed = 1 | 2\\|3|5"}},
                                        "rows": [{"quantity": "x", "source": "y", "result": "dense:p"}]})");
  const Validation validation = load_validations((directory / "a.json").parent_path()).at(0);
  BOOST_TEST(validation.runs.size() == 3u);
  BOOST_TEST(validation.means.at("dense").size() == 3u);
  BOOST_TEST(validation.runs.at("dense 2").overrides[1] == "Tissue seed=2|3");
  const RunRequest &last = validation.runs.at("dense 3");
  BOOST_REQUIRE(last.overrides.size() == 2u);
  BOOST_TEST(last.overrides[1] == "Tissue seed=5");
  for (const char *wrong : {"Tissue seed", "Tissue seed = 1"})
    BOOST_TEST(
        error_of(std::string(R"({"runs": {"": {"input": "x.prm", "each": ")") + wrong + R"("}}, "rows": []})")
            .find("two values or more") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_table_goes_between_its_marks) {
  const std::string once = with_table("# Head\n", "| a |\n");
  BOOST_TEST(once.find("# Head\n") == 0u);
  const std::string twice = with_table(once + "\nbehind\n", "| b |\n");
  BOOST_TEST(twice.find("| a |") == std::string::npos);
  BOOST_TEST(twice.find("| b |") != std::string::npos);
  BOOST_TEST(twice.find("\nbehind\n") != std::string::npos);
}

// A row that another program computed, or none, is not taken for one of today's.
BOOST_AUTO_TEST_CASE(the_table_says_which_program_computed_it) {
  Validation validation;
  validation.name = "ring";
  validation.rows.resize(2);
  validation.rows[0].quantity = "a";
  validation.rows[1].quantity = "b";
  Validation other = validation;
  other.name = "ball";
  std::vector<ValidationResult> results = {{"ring", "a", "1", "%", "2", "met", "1234 avx2", "2026-11-29"},
                                           {"ring", "b", "1", "%", "2", "met", "1234 avx2", "2026-11-29"}};
  BOOST_TEST(
      markdown({validation}, results).find("Computed by 1234 avx2 on 2026-11-29: all 2 rows.\n\n| scene |") ==
      0u);
  results[1].program = "";
  const std::string mixed = markdown({validation, other}, results);
  BOOST_TEST(mixed.find("Computed by 1234 avx2 on 2026-11-29: 1 row (ring). By a program that was not noted: "
                        "1 row (ring). Not run: 2 rows (ball).\n") == 0u);
}

BOOST_AUTO_TEST_CASE(results_survive_the_file) {
  const TemporaryDirectory directory;
  write_results(directory / "r.csv", {{"name", "a \"quantity\", with a comma", "1.5", "%", "3", "met",
                                       "1234abcd avx2", "2026-11-29"}});
  const std::vector<ValidationResult> back = read_results(directory / "r.csv");
  BOOST_REQUIRE(back.size() == 1u);
  BOOST_TEST(back[0].quantity == "a \"quantity\", with a comma");
  BOOST_TEST(back[0].verdict == "met");
  BOOST_TEST(back[0].program == "1234abcd avx2");
  BOOST_TEST(back[0].date == "2026-11-29");
  set_content(directory / "old.csv", "name,quantity,value,unit,cpu_time_s,verdict\na,b,1,%,2,met\n");
  BOOST_REQUIRE(read_results(directory / "old.csv").size() == 1u);
  BOOST_TEST(read_results(directory / "old.csv")[0].program == "");
  BOOST_TEST(read_results(directory / "none.csv").empty());
}

BOOST_AUTO_TEST_CASE(mistakes_are_named) {
  const auto has = [](const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
  };
  BOOST_TEST(has(error_of("{" + runs + R"(, "rows": [{"quantitie": "x"}]})"), "Did you mean 'quantity'?"));
  BOOST_TEST(has(error_of("{" + runs + "}"), "at least one of 'runs' and one of 'rows'"));
  BOOST_TEST(
      has(error_of("{" + runs + R"(, "rows": [{"quantity": "x", "source": "y"}]})"), "'result' is missing"));
  BOOST_TEST(has(
      error_of(
          "{" + runs +
          R"(, "rows": [{"quantity": "x", "source": "y", "result": "p", "relative_to": "q", "unit": "Pa"}]})"),
      "is in %"));
  const std::string row = R"({"quantity": "x", "source": "y", "result": "p"})";
  BOOST_TEST(has(error_of("{" + runs + ", \"rows\": [" + row + ", " + row + "]}"),
                 "a quantity needs a name of its own"));
  BOOST_TEST(has(error_of("{"), "a.json"));
}

BOOST_AUTO_TEST_SUITE_END()
