// The scene itself, by the program: the same bits on 1 and 2 threads, on 1 and 2 ranks, and after
// kill -9 and --resume. The program is built beside the tests.
#include <boost/test/unit_test.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace fs = std::filesystem;

namespace {
const std::string program = std::string(TURGOR_BINARY_DIR) + "/app/turgor";
const std::string input = std::string(TURGOR_SOURCE_DIR) + "/inputs/tissue_gravity.prm";

struct Folder {
  fs::path path = fs::temp_directory_path() / ("turgor_gravity_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

// A small piece for a short time; 4 elements, 16 RVEs.
std::string command(const fs::path &directory, const std::string &more) {
  std::string text = program + " run " + input + " -o " + directory.string() + " --quiet";
  for (const char *set :
       {"Tissue gravity/Cells=4", "Tissue/Elements x=2", "Tissue/Elements y=2", "Tissue/Degree=1",
        "Cell/Nodes per side=8", "Time/End time=4e-5", "Time/Checkpoint interval=0",
        "Time/Output interval=1.5e-5", "Tissue gravity/Steps between rebalances=3"})
    text += std::string(" --set '") + set + "'";
  return text + " " + more + " > " + directory.string() + ".log 2>&1";
}

std::string read(const fs::path &file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void compare(const fs::path &a, const fs::path &b) {
  for (const char *name : {"probe.csv", "energies.csv", "cell_displacement.csv", "rve_outlines.csv"}) {
    BOOST_TEST(fs::exists(a / name), name);
    BOOST_TEST((read(a / name) == read(b / name)), b.string() << "/" << name << " differs");
  }
}
// Every RVE called, and with answers from the table.
void same_bits(const std::string &entries) {
  BOOST_REQUIRE_MESSAGE(fs::exists(program), program << " is not built");
  const Folder folder;
  const auto run = [&](const std::string &name, const std::string &more) {
    const int status = std::system(command(folder.path / name, entries + " " + more).c_str());
    BOOST_TEST(status == 0, read(folder.path / (name + ".log")));
    return folder.path / name;
  };
  const fs::path alone = run("alone", "--threads 1");
  compare(alone, run("threads", "--threads 2"));
  compare(alone, run("ranks", "--threads 1 --ranks 2"));
  if (!entries.empty()) compare(alone, run("three_ranks", "--threads 1 --ranks 3"));

  // Killed three times at unequal moments of its work, then left to finish.
  const fs::path killed = folder.path / "killed";
  for (const int rows : {3, 12, 30}) {
    const pid_t child = ::fork();
    if (child == 0) {
      const std::string line =
          "exec " + command(killed, entries + (rows == 3 ? " --threads 1" : " --threads 1 --resume"));
      ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char *>(nullptr));
      ::_exit(127);
    }
    for (int wait = 0; wait < 2000; ++wait) {
      const std::string text = read(killed / "probe.csv");
      if (std::count(text.begin(), text.end(), '\n') > rows || ::waitpid(child, nullptr, WNOHANG) == child)
        break;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  compare(alone, run("killed", "--threads 1 --resume"));
}
}  // namespace

BOOST_AUTO_TEST_SUITE(tissue_gravity)

BOOST_AUTO_TEST_CASE(same_bits_on_threads_ranks_and_after_kill) { same_bits(""); }

BOOST_AUTO_TEST_CASE(same_bits_with_certified_skipping) {
  same_bits("--set 'Skipping/Skipping=certified' --set 'Skipping/Audit share=0.05'");
}

// Rows of bricks are moved by half a cell, so the second period of their RVE is oblique: who draws it needs
// all four components. By hand: half the first period.
BOOST_AUTO_TEST_CASE(bricks_tell_their_oblique_periods) {
  const Folder folder;
  const fs::path made = folder.path / "bricks";
  const int status =
      std::system(command(made, "--set Structure/Structure=brick --set 'Time/End time=3e-6'").c_str());
  BOOST_TEST(status == 0, read(folder.path / "bricks.log"));
  std::istringstream lines(read(made / "rve_outlines.csv"));
  const auto fields = [](const std::string &line) {
    std::vector<std::string> all;
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');) all.push_back(field);
    return all;
  };
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = fields(line);
  std::getline(lines, line);
  const std::vector<std::string> values = fields(line);
  const auto value = [&](const std::string &name) {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k].find(name + " ") != std::string::npos) return std::stod(values[k]);
    BOOST_FAIL("no column " << name);
    return 0.;
  };
  BOOST_TEST(value("period_xy") == 0.5 * value("period_x"), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(value("period_yx") == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
