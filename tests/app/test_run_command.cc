// A whole run of the tiny scene: files, exit codes, resume.
#include "app/run_command.h"
#include "micro/io/run_context.h"
#include "tests/app/temporary_directory.h"
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

namespace
{
struct Run
{
  Run()
  {
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
} // namespace

BOOST_FIXTURE_TEST_SUITE(run_of_a_scene, Run)

BOOST_AUTO_TEST_CASE(finished_run_leaves_its_summary)
{
  BOOST_TEST(go() == 0);
  const auto json = summary();
  BOOST_TEST(json["status"] == "finished");
  BOOST_TEST(json["scenario"] == "tiny");
  BOOST_TEST(json["version"] == program_version());
  // x_n = (1 - rate dt)^n = 0.9^25
  BOOST_TEST(json["results"]["x"]["value"].get<double>() == 0.07178979876918530, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(json["results"]["x"]["unit"] == "1");
  BOOST_TEST(json["active_terms"] == nlohmann::json({"decay"}));
  BOOST_TEST(json["fields"] == nlohmann::json({"x"}));
  BOOST_TEST(json["notes"]["scheme"] == "explicit Euler");
  BOOST_TEST(json["wall_time_s"].get<double>() > 0.);
  BOOST_TEST(json["cpu_time_s"].get<double>() > 0.);
  BOOST_TEST(json["peak_memory_bytes"].get<double>() > 1e6);
  BOOST_TEST(content(directory / "out/input.prm").find("set Rate = 100") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(stopped_and_resumed_gives_the_same_bytes)
{
  BOOST_TEST(go() == 0);
  const std::string whole = series();
  const auto x = summary()["results"]["x"]["value"].get<double>();
  for (const int stop : {0, 1, 10, 17, 24})
    {
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
BOOST_AUTO_TEST_CASE(child_of_the_next_test)
{
  const char *place = std::getenv("TURGOR_TEST_CHILD");
  if (place == nullptr)
    return;
  options.file = std::filesystem::path(place) / "in.prm";
  options.directory = std::filesystem::path(place) / "out";
  BOOST_TEST(go() == 0);
}

BOOST_AUTO_TEST_CASE(killed_and_resumed_gives_the_same_bytes)
{
  input("set Scenario = tiny\nset Steps = 1000\n");
  BOOST_TEST(go() == 0);
  const std::string whole = series();
  for (const unsigned int microseconds : {0u, 500u, 7000u, 40000u})
    {
      std::filesystem::remove_all(directory / "out");
      ::setenv("TURGOR_TEST_CHILD", directory.path.c_str(), 1);
      const pid_t child = ::fork();
      if (child == 0)
        {
          ::execl("/proc/self/exe", "test_app", "--run_test=run_of_a_scene/child_of_the_next_test", "--log_level=nothing",
                  "--report_level=no", nullptr);
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

BOOST_AUTO_TEST_CASE(divergence_is_exit_code_1_with_a_summary)
{
  input("set Scenario = tiny\nset Mode = diverge\n");
  BOOST_TEST(go() == 1);
  const auto json = summary();
  BOOST_TEST(json["status"] == "failed");
  BOOST_TEST(json["message"].get<std::string>().find("'x' is not a finite number") != std::string::npos);
  // the rows before it are kept: header and 12 rows
  const std::string text = series();
  BOOST_TEST(std::count(text.begin(), text.end(), '\n') == 13);
}

BOOST_AUTO_TEST_CASE(resume_with_another_input_is_refused_and_nothing_touched)
{
  TinyScene::stop_at_step = 12;
  BOOST_TEST(go() == 130);
  const std::string before = series();
  options.overrides = {"Law/Rate=99"};
  options.resume = true;
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"belongs to another input"});
  BOOST_TEST(series() == before);
  BOOST_TEST(summary()["status"] == "stopped");
}

BOOST_AUTO_TEST_CASE(resume_without_a_checkpoint_starts_at_the_beginning)
{
  options.resume = true;
  BOOST_TEST(go() == 0);
  BOOST_TEST(summary()["status"] == "finished");
}

BOOST_AUTO_TEST_CASE(new_run_removes_what_it_made_and_nothing_else)
{
  BOOST_TEST(go() == 0);
  set_content(directory / "out/my_notes.txt", "mine");
  set_content(directory / "out/my_table.csv", "mine");
  input("set Scenario = tiny\nset Steps = 5\n");
  BOOST_TEST(go() == 0);
  BOOST_TEST(content(directory / "out/my_notes.txt") == "mine");
  BOOST_TEST(content(directory / "out/my_table.csv") == "mine");
  BOOST_TEST(!std::filesystem::exists(directory / "out/checkpoint.0"));
  BOOST_TEST(!std::filesystem::exists(directory / "out/checkpoint.1"));
}

BOOST_AUTO_TEST_CASE(input_refused_by_the_scene_itself_writes_nothing)
{
  input("set Scenario = tiny\nset Mode = refuse\n");
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"'Mode' = refuse"});
  BOOST_TEST(!std::filesystem::exists(directory / "out"));
}

BOOST_AUTO_TEST_CASE(output_directory_that_is_a_file)
{
  options.directory = directory / "in.prm";
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"is a file"});
  options.directory = directory / "in.prm/deeper";
  BOOST_CHECK_EXCEPTION(go(), InputError, Says{"cannot be written"});
}

BOOST_AUTO_TEST_SUITE_END()
