// The input of a study:
//   set Reference = LABEL or DIRECTORY     the run all others are measured against
//   subsection Run LABEL
//     set Method = ..., set Settings = ...  for the table
//     set Input = FILE.prm                  relative to the study file
//     set Overrides = Sec/Name=value; Sec/Name=value
//     set Threads = 1
//   end
// or, without Reference and with
//   set Picture = NAME                     drawn by app/plots/study_NAME.py
//   subsection Axis LABEL                  one run for each value of an entry: label and method LABEL, settings the value
//     set Input, Overrides, Threads          as above
//     set Entry = Section/Name
//     set Values = 1 | 10 | 100
//   end
// The first is a study of errors (error_vs_time.csv); the second collects all results of the runs (results.csv).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace turgor
{
struct StudyRun
{
  std::string label, method, settings;
  std::filesystem::path input;
  std::vector<std::string> overrides;
  unsigned int threads = 1;
};

struct StudyInput
{
  std::string reference;                     ///< label of a run; empty when it is a directory
  std::filesystem::path reference_directory; ///< empty when it is a run
  std::string picture;                       ///< of a study of results
  bool of_errors() const { return !reference.empty() || !reference_directory.empty(); }
  std::vector<StudyRun> runs;
};

/// Throws InputError as for any input file.
StudyInput load_study(const std::filesystem::path &file);
} // namespace turgor
