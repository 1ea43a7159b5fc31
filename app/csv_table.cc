#include "app/csv_table.h"

#include "micro/io/prm_text.h"
#include "micro/io/number_text.h"

#include <algorithm>
#include <charconv>
#include <fstream>
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
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line))
    throw std::runtime_error(file.string() + " is missing or empty.");
  CsvTable table;
  table.file = file;
  for (const std::string &name : split_trimmed(line, ','))
    table.names.push_back(name.substr(0, name.find(" [")));
  table.columns.resize(table.names.size());
  for (unsigned int number = 2; std::getline(in, line); ++number)
    {
      if (trimmed(line).empty())
        continue;
      const std::vector<std::string> words = split_trimmed(line, ',');
      const auto refuse = [&] {
        throw std::runtime_error(file.string() + ", line " + number_text(number) + ": '" + line + "' is not a row of " +
                                 number_text(table.names.size()) + " numbers.");
      };
      if (words.size() != table.names.size())
        refuse();
      for (std::size_t i = 0; i < words.size(); ++i)
        {
          double value = 0.;
          const auto [end, error] = std::from_chars(words[i].data(), words[i].data() + words[i].size(), value);
          if (error != std::errc() || end != words[i].data() + words[i].size())
            refuse();
          table.columns[i].push_back(value);
        }
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
