// What `turgor validate` runs and compares: one small file inputs/validation/NAME.json a scene.
//
//   {
//     "runs":  {"": {"input": "../laplace.prm", "overrides": ["Dimension=2"], "threads": 1}},
//     "rows":  [{"quantity": "pressure over the law of Laplace, 2D", "source": "A.1", "thesis": "6 %",
//                "result": "pressure", "relative_to": "closed_form", "most": 1}]
//   }
//
// runs: label and what to run, the input relative to the file; one run has usually the empty label.
//   each                       (not always) "ENTRY = VALUE | VALUE | ...": one run a value, "LABEL 1", "LABEL
//                              2", ...; LABEL:NAME then is the mean over them, and the row has the standard
//                              error of the mean; a | inside a value is \\| there
// rows: one line of the table each.
//   quantity, source, thesis   text: what is compared, with what, and the thesis's own error
//   result                     NAME of an entry in results of summary.json, or LABEL:NAME of the run with
//                              that label
//   relative_to                (not always) NAME, LABEL:NAME or a number: the row is 100 (result/relative_to
//                              - 1) in %
//   scale, unit                (not always, without relative_to) the row is scale times result, in this unit
//   least, most                (not always) the target: least <= row <= most, with most alone |row| <= most;
//                              without both the row is reported and has no verdict
#pragma once

#include "app/cached_run.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace turgor {
struct ValidationRow {
  std::string quantity, source, thesis;
  std::string result, relative_to;  ///< relative_to: empty for none
  double scale = 1.;
  std::string unit;
  std::optional<double> least, most;
};

struct Validation {
  std::string name;  ///< of the file
  std::map<std::string, RunRequest> runs;
  std::map<std::string, std::vector<std::string>> means;  ///< label of several runs, their labels
  std::vector<ValidationRow> rows;
};

/// All files of the directory by name; throws InputError with file and reason.
std::vector<Validation> load_validations(const std::filesystem::path &directory);
}  // namespace turgor
