// A whole run of the tiny scene: files, exit codes, resume.
#include "app/run_command.h"
#include "run/manifest.h"
#include "run/output_files.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"
#include "tests/app/tiny_scene.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

using namespace turgor;
using namespace turgor::test;

namespace {
struct Run {
  Run() {
    TinyScene::stop_at_step = -1;
    request_stop(false);
    input("set Scenario = tiny\n");
    options.file = directory / "in.prm";
    options.directory = directory / "out";
    options.quiet = true;
    options.threads = 1;
  }
  void input(const std::string &text) const { set_content(directory / "in.prm", text); }
  int go() const { return run_command(options, tiny_registry(), nullptr); }
  nlohmann::json summary() const { return nlohmann::json::parse(content(directory / "out/summary.json")); }
  std::string series() const { return content(directory / "out/series.csv"); }

  TemporaryDirectory directory;
  RunOptions options;
};
}  // namespace

BOOST_FIXTURE_TEST_SUITE(run_of_a_scene, Run)

BOOST_AUTO_TEST_CASE(finished_run_leaves_its_summary) {
  BOOST_TEST(go() == 0);
  const auto json = summary();
  BOOST_TEST(json["status"] == "finished");
  BOOST_TEST(json["scenario"] == "tiny");
  BOOST_TEST(json["version"] == program_version());
  // x_n = (1 - rate dt)^n = 0.9^25
  BOOST_TEST(json["results"]["x"]["value"].get<double>() == 0.07178979876918530,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(json["results"]["x"]["unit"] == "1");
  BOOST_TEST(json["active_terms"] == nlohmann::json({"decay"}));
  BOOST_TEST(json["fields"] == nlohmann::json({"x"}));
  BOOST_TEST(json["notes"]["scheme"] == "explicit Euler");
  BOOST_TEST(json["wall_time_s"].get<double>() > 0.);
  BOOST_TEST(json["cpu_time_s"].get<double>() > 0.);
  BOOST_TEST(json["peak_memory_bytes"].get<double>() > 1e6);
  BOOST_TEST(content(directory / "out/input.prm").find("set Rate = 100") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(stopped_and_resumed_gives_the_same_bytes) {
  BOOST_TEST(go() == 0);
  const std::string whole = series();
  const auto x = summary()["results"]["x"]["value"].get<double>();
  for (const int stop : {0, 1, 10, 17, 24}) {
    options.directory = directory / "out";
    options.resume = false;
    TinyScene::stop_at_step = stop;
    BOOST_TEST(go() == 130);
    BOOST_TEST(summary()["status"] == "stopped");
    TinyScene::stop_at_step = -1;
    request_stop(false);
    options.resume = true;
    BOOST_TEST(go() == 0);
    BOOST_TEST(series() == whole);
    BOOST_TEST(summary()["results"]["x"]["value"].get<double>() == x);
  }
}

/// Run as a program of its own by the test below, and killed.
BOOST_AUTO_TEST_CASE(child_of_the_next_test) {
  const char *place = std::getenv("TURGOR_TEST_CHILD");
  if (place == nullptr) return;
  options.file = std::filesystem::path(place) / "in.prm";
  options.directory = std::filesystem::path(place) / "out";
  BOOST_TEST(go() == 0);
}

BOOST_AUTO_TEST_CASE(killed_and_resumed_gives_the_same_bytes) {
  input("set Scenario = tiny\nset Steps = 1000\n");
  BOOST_TEST(go() == 0);
  const std::string whole = series();
  for (const unsigned int microseconds : {0u, 500u, 7000u, 40000u}) {
    std::filesystem::remove_all(directory / "out");
    ::setenv("TURGOR_TEST_CHILD", directory.path.c_str(), 1);
    const pid_t child = ::fork();
    if (child == 0) {
      ::execl("/proc/self/exe", "test_app", "--run_test=run_of_a_scene/child_of_the_next_test",
              "--log_level=nothing", "--report_level=no", nullptr);
      ::_exit(1);
    }
    ::unsetenv("TURGOR_TEST_CHILD");
    int status = 0;
    while (!std::filesystem::exists(directory / "out/series.csv") && ::waitpid(child, &status, WNOHANG) == 0)
      ::usleep(100);
    ::usleep(microseconds);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    options.resume = true;
    BOOST_TEST(go() == 0);
    BOOST_TEST(series() == whole);
  }
}

BOOST_AUTO_TEST_CASE(divergence_is_exit_code_1_with_a_summary) {
  input("set Scenario = tiny\nset Mode = diverge\n");
  BOOST_TEST(go() == 1);
  const auto json = summary();
  BOOST_TEST(json["status"] == "failed");
  BOOST_TEST(json["message"].get<std::string>().find("'x' is not a finite number") != std::string::npos);
  // the rows before it are kept: header and 12 rows
  const std::string text = series();
  BOOST_TEST(std::count(text.begin(), text.end(), '\n') == 13);
}

BOOST_AUTO_TEST_CASE(resume_with_another_input_is_refused_and_nothing_touched) {
  TinyScene::stop_at_step = 12;
  BOOST_TEST(go() == 130);
  const std::string before = series();
  options.overrides = {"Law/Rate=99"};
  options.resume = true;
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"belongs to another input"});
  BOOST_TEST(series() == before);
  BOOST_TEST(summary()["status"] == "stopped");
}

BOOST_AUTO_TEST_CASE(finished_run_goes_on_to_a_later_end) {
  input("set Scenario = tiny\nset Steps = 45\n");
  BOOST_TEST(go() == 0);
  const std::string whole = series();
  const double x = summary()["results"]["x"]["value"];
  std::filesystem::remove_all(directory / "out");
  input("set Scenario = tiny\nset Steps = 20\n");
  BOOST_TEST(go() == 0);
  options.resume = true;
  options.overrides = {"Steps=45", "Remark=longer"};  // what changes no state may change
  BOOST_TEST(go() == 0);
  BOOST_TEST(series() == whole);
  BOOST_TEST((summary()["results"]["x"]["value"] == x));
  BOOST_TEST(content(directory / "out/input.prm").find("set Remark = longer") != std::string::npos);
  options.overrides = {"Steps=44"};
  BOOST_CHECK_EXCEPTION(go(), InputError,
                        Says{"'Steps' was 45 and is 44. A resumed run can end later, not earlier."});
  BOOST_TEST(series() == whole);
}

BOOST_AUTO_TEST_CASE(resume_of_a_finished_run_leaves_it) {
  input("set Scenario = tiny\nset Steps = 5\n");  // no checkpoint
  BOOST_TEST(go() == 0);
  const std::string before = content(directory / "out/summary.json");
  options.resume = true;
  options.overrides = {"Remark=other"};
  BOOST_TEST(go() == 0);
  BOOST_TEST(content(directory / "out/summary.json") == before);
  options.overrides = {"Steps=6"};
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"without a checkpoint to go on from"});
  options.overrides = {"Law/Rate=99"};
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"without a checkpoint to go on from"});
  BOOST_TEST(content(directory / "out/summary.json") == before);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_resumed_is_replaced_when_asked_for) {
  TinyScene::stop_at_step = 12;
  BOOST_TEST(go() == 130);
  TinyScene::stop_at_step = -1;
  request_stop(false);
  options.overrides = {"Law/Rate=99"};
  options.resume = options.overwrite = true;
  BOOST_TEST(go() == 0);
  const std::string other = series();
  std::filesystem::remove_all(directory / "out");
  options.resume = options.overwrite = false;
  BOOST_TEST(go() == 0);
  BOOST_TEST(series() == other);
}

BOOST_AUTO_TEST_CASE(files_that_entries_name_belong_to_the_run) {
  std::filesystem::create_directories(directory / "inputs");
  const auto table = [&](const std::string &text) { set_content(directory / "inputs/table.csv", text); };
  table("1, 2");
  set_content(directory / "inputs/in.prm", "set Scenario = tiny\nset Table = table.csv\n");
  options.file =
      directory / "inputs/in.prm";  // it is looked up beside the input, wherever the program was started
  TinyScene::stop_at_step = 12;
  BOOST_TEST(go() == 130);
  BOOST_TEST(content(directory / "out/input_files/table.csv") == "1, 2");
  const std::string identity = summary()["identity"];
  options.resume = true;
  table("1, 3");
  BOOST_CHECK_EXCEPTION(go(), InputError,
                        Says{"belongs to another input: 'Table' was a file with the checksum "});
  // the copy in the output directory is the file of the run; its own input.prm names it
  std::filesystem::remove_all(directory / "inputs");
  options.file = directory / "out/input.prm";
  TinyScene::stop_at_step = -1;
  request_stop(false);
  BOOST_TEST(go() == 0);
  BOOST_TEST((summary()["identity"] == identity));
  options.file = directory / "in.prm";
  input("set Scenario = tiny\nset Table = gone.csv\n");
  options.resume = false;
  options.overwrite = true;
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"gone.csv cannot be read"});
  BOOST_TEST(content(directory / "out/input_files/table.csv") == "1, 2");
}

BOOST_AUTO_TEST_CASE(summary_says_what_was_computed_by_what) {
  BOOST_TEST(go() == 0);
  const auto json = summary();
  BOOST_TEST(json["build"]["hash"].get<std::string>().size() >= 16u);
  for (const char *name : {"commit", "compiler"}) BOOST_TEST(!json["build"][name].get<std::string>().empty());
  BOOST_TEST(!json["instruction_set"].get<std::string>().empty());
  BOOST_TEST(json["date"].get<std::string>().find("T") == 10u);
  BOOST_TEST((json["identity"] == load_input(options.file, {}, tiny_registry()).identity.hash()));
}

BOOST_AUTO_TEST_CASE(resume_without_a_checkpoint_starts_at_the_beginning) {
  options.resume = true;
  BOOST_TEST(go() == 0);
  BOOST_TEST(summary()["status"] == "finished");
}

BOOST_AUTO_TEST_CASE(run_that_fails_before_it_has_results_leaves_the_earlier_ones) {
  BOOST_TEST(go() == 0);
  const std::string before = content(directory / "out/summary.json"), rows = series(),
                    checkpoint = content(directory / "out/checkpoint.0");
  input("set Scenario = tiny\nset Steps = 1\nset Mode = diverge\n");
  options.overwrite = true;
  for (int time = 0; time < 2; ++time) {
    BOOST_TEST(go() == 1);
    BOOST_TEST(content(directory / "out/summary.json") == before);
    BOOST_TEST(series() == rows);
    BOOST_TEST(content(directory / "out/checkpoint.0") == checkpoint);
    BOOST_TEST(!std::filesystem::exists(directory / "out/turgor_earlier_run"));
    const auto json = nlohmann::json::parse(content(directory / "out/turgor_failed_run/summary.json"));
    BOOST_TEST(json["status"] == "failed");
  }
  // one that has results replaces them all
  input("set Scenario = tiny\nset Steps = 2\n");
  BOOST_TEST(go() == 0);
  BOOST_TEST(summary()["status"] == "finished");
  BOOST_TEST(!std::filesystem::exists(directory / "out/turgor_failed_run"));
  BOOST_TEST(!std::filesystem::exists(directory / "out/checkpoint.0"));
}

BOOST_AUTO_TEST_CASE(earlier_run_comes_back_when_the_new_one_was_killed_before_it_had_results) {
  BOOST_TEST(go() == 0);
  const std::string before = content(directory / "out/summary.json"), rows = series();
  {
    OutputFiles killed(directory / "out");
    killed.begin();
    claim(directory / "out", "summary.json");
    set_content(directory / "out/summary.json", "of the one that is killed");
  }
  OutputFiles next(directory / "out");
  BOOST_TEST(content(directory / "out/summary.json") == before);
  BOOST_TEST(series() == rows);
  BOOST_TEST(!std::filesystem::exists(directory / "out/turgor_earlier_run"));
}

BOOST_AUTO_TEST_CASE(directory_in_use_is_refused) {
  const DirectoryLock lock(directory / "out", "Wait.");
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"is in use by process " + std::to_string(::getpid())});
}

BOOST_AUTO_TEST_CASE(new_run_removes_what_it_made_and_nothing_else) {
  BOOST_TEST(go() == 0);
  set_content(directory / "out/my_notes.txt", "mine");
  set_content(directory / "out/my_table.csv", "mine");
  input("set Scenario = tiny\nset Steps = 5\n");
  options.overwrite = true;
  BOOST_TEST(go() == 0);
  BOOST_TEST(content(directory / "out/my_notes.txt") == "mine");
  BOOST_TEST(content(directory / "out/my_table.csv") == "mine");
  BOOST_TEST(!std::filesystem::exists(directory / "out/checkpoint.0"));
  BOOST_TEST(!std::filesystem::exists(directory / "out/checkpoint.1"));
}

BOOST_AUTO_TEST_CASE(input_refused_by_the_scene_itself_writes_nothing) {
  input("set Scenario = tiny\nset Mode = refuse\n");
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"'Mode' = refuse"});
  BOOST_TEST(!std::filesystem::exists(directory / "out"));
}

BOOST_AUTO_TEST_CASE(output_directory_that_is_a_file) {
  options.directory = directory / "in.prm";
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"is a file"});
  options.directory = directory / "in.prm/deeper";
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"cannot be written"});
}

BOOST_AUTO_TEST_SUITE_END()
