// `turgor compare INPUT`: a tissue by finite elements and RVEs against every one of its cells, error beside
// run time, and where the error comes from.
//
//   total    FE2 over all cells - 1: the same tissue, its sides as the interior (counterpart.h)
//   part     FE2 over FE2 with one thing refined - 1: mesh, RVE size, time step, skipping
//   number   of cells: what all cells come to when there are ever more, over what they are, - 1; by
//            2 f(n) - f(n/2), as what ends and clamp do goes with 1/n
//   rest     what is left of the total when every part is taken out: what does not go
//            with 1/n (sides of a block at such sizes), the particles' own error
//   surface  all cells with free sides over the same with sides as the interior - 1; in no FE2, so in no
//   error
//
// Runs and pictures are those of a study (study_runner.h), in whose directory the input of the cells, the
// study and split.csv are left.
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
