#include "micro/io/series_file.h"

#include "micro/io/number_text.h"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

namespace turgor
{
std::string SeriesFile::header_of(const std::vector<Column> &columns)
{
  std::string line;
  for (const Column &column : columns)
    {
      const std::string text = column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
      if (text.empty() || text.find_first_of(",\n\r\"") != std::string::npos)
        throw std::logic_error("A column cannot be named '" + text + "'.");
      line += (line.empty() ? "" : ",") + text;
    }
  return line;
}

void SeriesFile::check_row(const std::string &name, const std::vector<Column> &columns, const std::vector<double> &values)
{
  if (values.size() != columns.size())
    throw std::logic_error("Series " + name + " has " + number_text(columns.size()) + " columns, not " +
                           number_text(values.size()) + ".");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw RunFailed("Series " + name + ": '" + columns[i].name + "' is not a finite number" +
                      (i > 0 ? " at " + columns[0].name + " = " + number_text(values[0]) + " " + columns[0].unit : "") +
                      "; the run has diverged.");
}

SeriesFile::SeriesFile(std::filesystem::path path_, std::string name_, const std::vector<Column> &columns_)
  : path(std::move(path_)), name(std::move(name_)), columns(columns_), header_line(header_of(columns_))
{
  file = std::fopen(path.c_str(), "w");
  if (file == nullptr)
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(errno) + ".");
  put(header_line + "\n");
}

SeriesFile::SeriesFile(std::filesystem::path path_, std::string name_, const std::vector<Column> &columns_,
                       const std::uint64_t length)
  : path(std::move(path_)), name(std::move(name_)), columns(columns_), header_line(header_of(columns_))
{
  std::error_code error;
  const std::uintmax_t there = std::filesystem::file_size(path, error);
  if (error || there < length)
    throw InputError(path.string() + " is shorter than when the checkpoint was written; it cannot be continued. "
                                     "Run without --resume to start again.");
  std::string first;
  std::getline(std::ifstream(path), first);
  if (first != header_line)
    throw InputError(path.string() + " has the columns '" + first + "', this program writes '" + header_line +
                     "'. Run without --resume to start again.");
  std::filesystem::resize_file(path, length);
  file = std::fopen(path.c_str(), "a");
  if (file == nullptr)
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(errno) + ".");
}

SeriesFile::~SeriesFile()
{
  if (file != nullptr)
    std::fclose(file);
}

void SeriesFile::put(const std::string &text)
{
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size())
    throw RunFailed("cannot write " + path.string() + ": " + std::strerror(errno) + ".");
}

void SeriesFile::add_row(const std::vector<double> &values)
{
  check_row(name, columns, values);
  std::string line;
  for (const double value : values)
    {
      char digits[32];
      const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
      line.append(line.empty() ? "" : ",").append(digits, end);
    }
  put(line + "\n");
  // Often enough for a person who watches the file, seldom enough to cost nothing.
  const auto now = std::chrono::steady_clock::now();
  if (now - last_flush > std::chrono::seconds(1))
    {
      if (std::fflush(file) != 0)
        throw RunFailed("cannot write " + path.string() + ": " + std::strerror(errno) + ".");
      last_flush = now;
    }
}

std::uint64_t SeriesFile::synchronise()
{
  if (std::fflush(file) != 0 || ::fsync(::fileno(file)) != 0)
    throw RunFailed("cannot write " + path.string() + ": " + std::strerror(errno) + ".");
  return static_cast<std::uint64_t>(std::filesystem::file_size(path));
}
} // namespace turgor
