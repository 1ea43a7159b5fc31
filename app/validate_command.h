// `turgor validate [NAME...]`: runs the validation scenes one by one and writes the table of doc/validation.md.
// A run is computed once for its input and this program; what is not asked for keeps the row it had.
#pragma once

#include "app/input.h"

#include <filesystem>
#include <string>
#include <vector>

namespace turgor
{
struct ValidateOptions
{
  std::vector<std::string> names; ///< of inputs/validation/NAME.json; empty: all
  std::filesystem::path root;     ///< holds inputs/validation and doc; empty: the repository this program was built from
  bool list_only = false, fresh = false;
};

/// Exit code: 0; 1 when a run failed or a row that was met is missed; 130 stopped. Throws InputError.
int validate_command(const ValidateOptions &options, const ScenarioRegistry &registry);
} // namespace turgor
