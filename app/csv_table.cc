#include "app/csv_table.h"

#include "micro/io/csv_text.h"

#include <algorithm>
#include <stdexcept>

namespace turgor
{
const std::vector<double> &CsvTable::column(const std::string &name) const
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw std::runtime_error(file.string() + " has no column '" + name + "'.");
  return columns[static_cast<std::size_t>(found - names.begin())];
}

CsvTable read_csv(const std::filesystem::path &file)
{
  const CsvText text(file);
  CsvTable table;
  table.file = file;
  for (const std::string &name : text.header.fields)
    table.names.push_back(name.substr(0, name.find(" [")));
  table.columns.resize(table.names.size());
  for (const CsvRow &row : text.rows)
    {
      text.require_fields(row, table.names.size());
      for (std::size_t i = 0; i < row.fields.size(); ++i)
        table.columns[i].push_back(text.number(row, i));
    }
  return table;
}

std::string csv_field(const std::string &text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}
} // namespace turgor
