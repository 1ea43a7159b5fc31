// `turgor study FILE.prm`: many variants of a few base inputs, each once, error against run time.
#pragma once

#include "app/input.h"

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
struct StudyOptions {
  std::filesystem::path file;
  std::filesystem::path directory;  ///< empty: runs/<file stem>
  std::vector<std::string> only;    ///< labels; empty: all
  bool list_only = false;
  bool fresh = false;
  unsigned int jobs = 1;  ///< runs beside each other
};

/// Exit code: 0 when every run finished; 1 when one failed or could not be measured, or a study of errors has
/// none (the table is written all the same); 130 stopped. Throws InputError.
int study_command(const StudyOptions &options, const ScenarioRegistry &registry);
}  // namespace turgor
