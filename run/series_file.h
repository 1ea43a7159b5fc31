// One table of a run, DIR/NAME.csv: a header "time [s],tip [m]", then a row per call, each
// number in the shortest form that reads back to the same bits.
#pragma once

#include "run/run_context.h"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
class SeriesFile {
 public:
  /// Starts the table afresh. Throws OutputFailed when it cannot be written.
  SeriesFile(std::filesystem::path path, std::string name, const std::vector<Column> &columns);

  /// Continues a table that was `length` bytes long; later bytes are cut.
  /// Throws InputError when the file is gone, shorter or its columns are others; OutputFailed when it cannot
  /// be written.
  SeriesFile(std::filesystem::path path, std::string name, const std::vector<Column> &columns,
             std::uint64_t length);

  SeriesFile(const SeriesFile &) = delete;
  SeriesFile &operator=(const SeriesFile &) = delete;

  void add_row(const std::vector<double>
                   &values);    ///< throws RunFailed for a non-finite value, OutputFailed for a full disk
  std::uint64_t synchronise();  ///< all rows are on disk; the length in bytes; throws OutputFailed
  const std::string &header() const { return header_line; }

  /// "time [s],tip [m]"; throws std::logic_error for a name a CSV header cannot hold.
  static std::string header_of(const std::vector<Column> &columns);

  /// What add_row demands; used by ranks that do not write, too.
  static void check_row(const std::string &name, const std::vector<Column> &columns,
                        const std::vector<double> &values);

 private:
  struct Close {
    void operator()(std::FILE *open) const { std::fclose(open); }
  };

  void open(const char *mode);
  void put(const std::string &text);
  void flush();  ///< also sees that the file is still in its directory

  std::filesystem::path path;
  std::string name;
  std::vector<Column> columns;
  std::string header_line;
  std::unique_ptr<std::FILE, Close> file;
  std::chrono::steady_clock::time_point last_flush = std::chrono::steady_clock::now();
};
}  // namespace turgor
