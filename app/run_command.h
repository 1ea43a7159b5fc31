// `turgor run` and `turgor check`: from options to exit code.
//   0 finished, 1 the run failed, 2 wrong input (nothing written), 130 stopped with a checkpoint.
#pragma once

#include "app/input.h"

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
class MpiSession;

struct RunOptions {
  std::filesystem::path file;
  std::filesystem::path directory;  ///< empty: runs/<file stem>
  std::vector<std::string> overrides;
  bool resume = false, quiet = false;
  bool overwrite = false;    ///< a finished run of another input
  bool identity = false;     ///< of check
  unsigned int threads = 0;  ///< 0: all cores (shared among ranks)
  unsigned int ranks = 1;
};

/// mpi is null in a serial run.
int run_command(const RunOptions &options, const ScenarioRegistry &registry, MpiSession *mpi);
int check_command(const RunOptions &options, const ScenarioRegistry &registry);

/// The program's version, as in summary.json and checkpoints.
std::string program_version();
}  // namespace turgor
