// `turgor validate [NAME...]`: runs the validation scenes one by one and writes DIR/validation.csv and
// DIR/validation.md. A run is computed once for its input and this program; what is not asked for keeps the
// row it had in DIR. The table of doc/validation.md in the source is rewritten only when asked for.
#pragma once

#include "app/input.h"

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
struct ValidateOptions {
  std::vector<std::string> names;  ///< of inputs/validation/NAME.json; empty: all
  std::filesystem::path
      root;  ///< holds inputs/validation and doc; empty: the repository this program was built from
  std::filesystem::path directory;  ///< of the results; empty: runs/validation
  bool list_only = false, fresh = false;
  bool update_doc = false;  ///< also doc/validation.md and doc/results/validation.csv of root
};

/// Exit code: 0; 1 when a run failed or one of the rows asked for failed or missed its target; 130 stopped.
/// Throws InputError.
int validate_command(const ValidateOptions &options, const ScenarioRegistry &registry);
}  // namespace turgor
