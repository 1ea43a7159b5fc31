// A CSV as a user or a spreadsheet may have saved it: a header line, then rows; blanks around fields, quotes,
// CRLF, a byte-order mark, empty lines and lines that begin with # are accepted. Numbers are whole fields
// (number_text.h), or a sentence names file, line and column.
//
//   const CsvText table("stiffness.csv");
//   for (const CsvRow &row : table.rows) moduli.push_back(table.number(row, 1));
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
struct CsvRow {
  unsigned int line = 0;  ///< of the file, from 1
  std::vector<std::string> fields;
};

class CsvText {
 public:
  /// Throws InputError when the file cannot be read, is empty, or leaves a quote open.
  explicit CsvText(std::filesystem::path file);

  std::filesystem::path file;
  CsvRow header;
  std::vector<CsvRow> rows;

  /// Throws InputError when the row has not `count` fields.
  void require_fields(const CsvRow &row, std::size_t count) const;

  /// The field as a finite number; throws InputError naming file, line, column and what stands there.
  double number(const CsvRow &row, std::size_t column) const;

  /// Throws InputError: "FILE, line N: what."
  [[noreturn]] void refuse(const CsvRow &row, const std::string &what) const;
};
}  // namespace turgor
