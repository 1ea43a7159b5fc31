// The table of `turgor validate`: what is kept of every row between calls (doc/results/validation.csv),
// its value from the runs' summaries, and the same as a table of doc/validation.md between two marks.
#pragma once

#include "app/validation_input.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace turgor {
/// Verdicts: met, missed, reported (no target), failed (a run gave no value); of a mean over runs, "within
/// the scatter" where two standard errors or less separate it from the nearest end of its target, on either
/// side.
struct ValidationResult {
  std::string name, quantity, value, unit, cpu_time, verdict;  ///< value in digits; empty when failed
  std::string program, date;  ///< which computed it, and when; empty in tables that did not keep them
};

struct Measured {
  double value = 0.;
  double error = 0.;  ///< standard error of a mean over runs; 0 for one run
};

/// The row's value from the directories of its runs (by label), means: labels of several runs; throws
/// std::runtime_error naming what is missing.
Measured value_of(const ValidationRow &row, const std::map<std::string, std::filesystem::path> &directories,
                  const std::map<std::string, std::vector<std::string>> &means = {});

std::string verdict_of(const ValidationRow &row, const Measured &measured);

/// "12.3", or "12.3 +- 0.4" of a mean.
std::string in_digits(const Measured &measured);

/// "at most 1 %", "0.98 to 1.02", ...; empty without a target.
std::string target_of(const ValidationRow &row);

/// Empty when there is no such file; throws InputError for a file of another kind.
std::vector<ValidationResult> read_results(const std::filesystem::path &file);
void write_results(const std::filesystem::path &file, const std::vector<ValidationResult> &results);

/// Which program computed the rows and when, in a line; then the rows of all validations in their order, "not
/// run" where there is no result.
std::string markdown(const std::vector<Validation> &validations,
                     const std::vector<ValidationResult> &results);

/// Whether it holds the marks between which the table stands.
bool has_table(const std::string &document);

/// Replaces what stands between the marks; without marks they are appended under a heading.
std::string with_table(const std::string &document, const std::string &table);
}  // namespace turgor
