// A CSV of numbers with one header line, "time [s],tip [m]", read whole.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace turgor {
struct CsvTable {
  std::vector<std::string> names, units;     ///< units may be empty
  std::vector<std::vector<double>> columns;  ///< columns[c][row]

  std::size_t rows() const { return columns.empty() ? 0 : columns[0].size(); }

  /// By name without unit; throws std::runtime_error naming the file and what it has when it is missing.
  const std::vector<double> &column(const std::string &name) const { return columns[index(name)]; }
  std::size_t index(const std::string &name) const;
  std::filesystem::path file;
};

/// Throws InputError with file, line and column for what is not a number.
CsvTable read_csv(const std::filesystem::path &file);

/// A CSV text of rows of (column, field); the columns are all that occur, in the order in which they do,
/// empty where a row lacks them.
std::string csv_of(const std::vector<std::vector<std::pair<std::string, std::string>>> &rows);

/// Quoted where a CSV needs it.
std::string csv_field(const std::string &text);
}  // namespace turgor
