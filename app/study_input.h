// The input of a study: which runs, what is measured in them and against what. `turgor parameters study`
// prints all entries.
//
//   set Input     = ../tissue_impact.prm      # of every run that names no other, relative to the study file
//   set Reference = finest                    # of every measure that names no other
//   subsection Run finest
//     set Overrides = SPH/Particles per side=24; Step fraction=0.4
//   end
//   subsection Run coarser                    # four runs: every one of the first with every one of the
//     second set Grid = SPH/Particles per side & Cell/Nodes per side = 6 & 8 | 10 & 14; Step fraction = 0.8 |
//     0.4
//   end
//   subsection Measure force                  # "force_rms [Pa]" and "error_force" of error_vs_time.csv
//     set Table   = loading
//     set Columns = stress_lower
//   end
//
// A reference is the label of a run, the directory of a finished run, a CSV file, or a closed form: an
// expression of the columns of the run's table (of its results, for a measure of a result). ; | & inside a
// value are written \; \| \&.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace turgor {
struct StudyRun {
  std::string label, method, settings;
  std::filesystem::path input;
  std::vector<std::string> overrides;                      ///< Section/Name=value, the swept ones last
  std::vector<std::pair<std::string, std::string>> swept;  ///< Section/Name and value
  unsigned int threads = 1;
  bool compared = true;  ///< with references; else its values are shown and no errors
};

enum class Weight {
  rms,        ///< of values and differences, over the abscissa (over rows, where rows are matched)
  max,        ///< largest value, largest difference
  end,        ///< in the last row
  mean,       ///< difference of the means; as of all below
  largest,    ///< of the largest values
  amplitude,  ///< of the first swing
  period      ///< of the first swing
};

struct StudyReference {
  enum class Kind { none, run, directory, file, expression };
  Kind kind = Kind::none;
  std::string text;            ///< as written: label or expressions
  std::filesystem::path path;  ///< of a directory or file
};

struct StudyMeasure {
  std::string name, title;  ///< of tables; of pictures
  std::string table,
      against;  ///< DIR/TABLE.csv and its abscissa (empty: its first column); no table: a result
  std::vector<std::string> columns,
      match;  ///< measured columns without units, or the one result; columns by which rows are matched
  Weight weight = Weight::rms;
  unsigned int parts = 0;  ///< means over so many parts of the abscissa are compared; 0: the rows
  double size =
      0.;  ///< what a difference is divided by, in the unit of the columns; 0: the size of the reference
  StudyReference reference;

  std::string weight_name() const;   ///< as the entry has it; empty for a result
  std::string value_column() const;  ///< force_rms: what the value is called in tables, without its unit
};

struct StudyInput {
  std::vector<StudyRun> runs;
  std::vector<StudyMeasure> measures;
  bool draw_all = true;                        ///< a panel for each result
  std::vector<std::vector<std::string>> draw;  ///< else the results of each panel
  bool of_errors() const;                      ///< some measure has a reference
};

/// Throws InputError as for any input file.
StudyInput load_study(const std::filesystem::path &file);

/// A commented study file of all entries with their defaults.
std::string study_parameters_text(const std::string &part = "");
}  // namespace turgor
