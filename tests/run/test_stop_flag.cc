// A program that comes to no place where it can stop ends by itself, in CPU time, and says so.
#include "run/cpu_clock.h"
#include "run/stop_flag.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(stop_flag)

BOOST_AUTO_TEST_CASE(what_does_not_stop_is_ended_with_a_sentence) {
  const TemporaryDirectory directory;
  const std::string said = (directory / "said").string();
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open(said.c_str(), O_WRONLY | O_CREAT, 0666), STDERR_FILENO);
    request_stop(false);  // whatever the cases before this one have wished
    install_stop_handler(1);
    std::raise(SIGTERM);
    while (process_cpu_seconds() < 20.)
      ;
    ::_exit(7);
  }
  int status = 0;
  BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
  BOOST_REQUIRE(WIFEXITED(status));
  BOOST_TEST(WEXITSTATUS(status) == 130);
  const std::string words = content(said);
  BOOST_TEST(words.find("turgor: asked to stop") == 0u);
  BOOST_TEST(words.find("--resume") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(two_signals_at_once_are_one_wish_and_a_later_one_ends_the_program) {
  const auto code_of = [](const double pause) {
    const pid_t child = ::fork();
    if (child == 0) {
      request_stop(false);
      install_stop_handler();
      std::raise(SIGINT);
      std::this_thread::sleep_for(std::chrono::duration<double>(pause));
      std::raise(SIGINT);
      ::_exit(stop_was_requested() ? 7 : 8);  // where a run would save
    }
    int status = 0;
    BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
    BOOST_REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status);
  };
  BOOST_TEST(code_of(0.) == 7);
  BOOST_TEST(code_of(0.005) == 7);
  BOOST_TEST(code_of(1.05 * second_wish_after) == 130);
}

BOOST_AUTO_TEST_SUITE_END()
