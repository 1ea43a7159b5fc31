#include "app/csv_table.h"

#include "app/nearest_name.h"
#include "run/csv_text.h"
#include "run/user_text.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
std::size_t CsvTable::index(const std::string &name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw std::runtime_error(file.string() + " has no column '" + name + "'." + suggestion(name, names));
  return static_cast<std::size_t>(found - names.begin());
}

CsvTable read_csv(const std::filesystem::path &file) {
  const CsvText text(file);
  CsvTable table;
  table.file = file;
  for (const std::string &name : text.header.fields) {
    const std::size_t bracket = std::min(name.find('['), name.size());
    table.names.push_back(trimmed(name.substr(0, bracket)));
    table.units.push_back(bracket + 2 < name.size()
                              ? trimmed(name.substr(bracket + 1, name.find(']', bracket) - bracket - 1))
                              : "");
  }
  table.columns.resize(table.names.size());
  for (const CsvRow &row : text.rows) {
    text.require_fields(row, table.names.size());
    for (std::size_t i = 0; i < row.fields.size(); ++i) table.columns[i].push_back(text.number(row, i));
  }
  return table;
}

std::string csv_of(const std::vector<std::vector<std::pair<std::string, std::string>>> &rows) {
  std::vector<std::string> columns;
  for (const auto &row : rows)
    for (const auto &[column, field] : row)
      if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
  std::string text;
  for (std::size_t c = 0; c < columns.size(); ++c) text += (c == 0 ? "" : ",") + csv_field(columns[c]);
  for (const auto &row : rows)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto found =
          std::find_if(row.begin(), row.end(), [&](const auto &entry) { return entry.first == columns[c]; });
      text += (c == 0 ? "\n" : ",") + (found == row.end() ? "" : csv_field(found->second));
    }
  return text + "\n";
}

std::string csv_field(const std::string &text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}
}  // namespace turgor
