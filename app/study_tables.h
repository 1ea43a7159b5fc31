// The files of a study:
//   results.csv         every run: what it was asked for, its state, cost and directory, all its results
//   error_vs_time.csv   (with measures) every run: value and error of each measure, cost
//   study.json          what pictures need to know beside: measures, swept entries (of all, of each run),
//                       results in their order, panels
// The value of a swept entry stands in a column of its name and unit, "Cell/Wall stiffness [N/m]", also of
// runs that another entry is swept in.
#pragma once

#include "app/cached_run.h"
#include "app/study_input.h"
#include "app/study_measure.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace turgor {
/// A run of the study, and what is known about it so far.
struct StudyRow : CachedRun {
  StudyRun run;
  std::map<std::string, std::string> units;  ///< of the swept entries of all runs
  std::vector<std::pair<std::string, std::string>>
      values;  ///< of the same, in the order in which the study names them
  std::vector<std::string>
      defined;  ///< results of the scene in the order of its definition (Scenario::outputs)
  std::vector<std::optional<MeasuredRun>> measured;  ///< one place a measure
};

void write_study_tables(const StudyInput &study, const std::vector<StudyRow> &rows,
                        const std::filesystem::path &directory);

/// To the terminal.
void print_study(const StudyInput &study, const std::vector<StudyRow> &rows);
}  // namespace turgor
