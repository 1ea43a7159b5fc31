#include "run/series_file.h"

#include "run/number_text.h"
#include "run/output_failed.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>

namespace turgor {
std::string SeriesFile::header_of(const std::vector<Column> &columns) {
  std::string line;
  for (const Column &column : columns) {
    const std::string text = column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
    if (text.empty() || text.find_first_of(",\n\r\"") != std::string::npos)
      throw std::logic_error("A column cannot be named '" + text + "'.");
    line += (line.empty() ? "" : ",") + text;
  }
  return line;
}

void SeriesFile::check_row(const std::string &name, const std::vector<Column> &columns,
                           const std::vector<double> &values) {
  if (values.size() != columns.size())
    throw std::logic_error("Series " + name + " has " + number_text(columns.size()) + " columns, not " +
                           number_text(values.size()) + ".");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw RunFailed(
          "Series " + name + ": '" + columns[i].name + "' is not a finite number" +
          (i > 0 ? " at " + columns[0].name + " = " + number_text(values[0]) + " " + columns[0].unit : "") +
          "; the run has diverged.");
}

SeriesFile::SeriesFile(std::filesystem::path path_, std::string name_, const std::vector<Column> &columns_)
    : path(std::move(path_)), name(std::move(name_)), columns(columns_), header_line(header_of(columns_)) {
  open("w");
  put(header_line + "\n");
  flush();
}

SeriesFile::SeriesFile(std::filesystem::path path_, std::string name_, const std::vector<Column> &columns_,
                       const std::uint64_t length)
    : path(std::move(path_)), name(std::move(name_)), columns(columns_), header_line(header_of(columns_)) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError(path.string() + (std::filesystem::exists(path, error) ? " is no file" : " is gone") +
                     "; the checkpoint continues it. Put it back, or run without --resume to start again.");
  const std::uintmax_t there = std::filesystem::file_size(path, error);
  if (error || there < length)
    throw InputError(path.string() +
                     " is shorter than when the checkpoint was written; it cannot be continued. "
                     "Run without --resume to start again.");
  std::string first;
  std::getline(std::ifstream(path), first);
  if (first != header_line)
    throw InputError(path.string() + " has the columns '" + first + "', this program writes '" + header_line +
                     "'. Run without --resume to start again.");
  open("a");  // before anything is cut: a table that cannot be continued stays whole
  if (::ftruncate(::fileno(file.get()), static_cast<off_t>(length)) != 0) throw OutputFailed(path);
}

void SeriesFile::open(const char *mode) {
  file.reset(std::fopen(path.c_str(), mode));
  if (!file) throw OutputFailed(path);
}

void SeriesFile::put(const std::string &text) {
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) throw OutputFailed(path);
}

void SeriesFile::flush() {
  if (std::fflush(file.get()) != 0) throw OutputFailed(path);
  struct stat now = {};
  if (::fstat(::fileno(file.get()), &now) == 0 && now.st_nlink == 0)
    throw OutputFailed(path.string() + " was removed while the run was writing it.");
  last_flush = std::chrono::steady_clock::now();
}

void SeriesFile::add_row(const std::vector<double> &values) {
  check_row(name, columns, values);
  std::string line;
  for (const double value : values) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    line.append(line.empty() ? "" : ",").append(digits, end);
  }
  put(line + "\n");
  // Often enough for a person who watches the file, seldom enough to cost nothing.
  if (std::chrono::steady_clock::now() - last_flush > std::chrono::seconds(1)) flush();
}

std::uint64_t SeriesFile::synchronise() {
  flush();
  struct stat now = {};
  // A device or a pipe in the file's place keeps nothing, so it has nothing to be brought to the disk
  // (EINVAL).
  if ((::fsync(::fileno(file.get())) != 0 && errno != EINVAL) || ::fstat(::fileno(file.get()), &now) != 0)
    throw OutputFailed(path);
  return static_cast<std::uint64_t>(now.st_size);
}
}  // namespace turgor
