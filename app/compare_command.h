// `turgor compare INPUT`: a tissue by finite elements and RVEs against every one of its cells, error beside
// run time, and where the error comes from (error_split.h).
//
// Runs and pictures are those of a study (study_runner.h), in whose directory the input of the cells, the
// study, split.csv and split.png are left.
#pragma once

#include "app/input.h"

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
struct CompareOptions {
  std::filesystem::path file;
  std::vector<std::string> overrides;  ///< of the tissue; what both sides have, of both
  std::filesystem::path directory;     ///< empty: runs/<file stem>_compared
  unsigned int threads = 1, jobs = 1;
  bool list_only = false;
};

/// Exit code as of study_command(). Throws InputError.
int compare_command(const CompareOptions &options, const ScenarioRegistry &registry);
}  // namespace turgor
