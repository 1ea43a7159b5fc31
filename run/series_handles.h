// What a scene gets for a table: rows into a file, or on ranks that do not write only the checks of the rows.
#pragma once

#include "run/output_files.h"
#include "run/run_context.h"
#include "run/series_file.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace turgor {
class SeriesHandle : public Series {
 public:
  SeriesHandle(std::shared_ptr<SeriesFile> file_, OutputFiles &files_)
      : file(std::move(file_)), files(files_) {}
  void add_row(const std::vector<double> &values) override {
    file->add_row(values);
    if (++rows == 2)  // the first is that of the start: nothing is computed yet
      files.keep();
  }

 private:
  std::shared_ptr<SeriesFile> file;
  OutputFiles &files;
  std::size_t rows = 0;
};

class UnwrittenSeries : public Series {
 public:
  UnwrittenSeries(std::string name_, std::vector<Column> columns_)
      : name(std::move(name_)), columns(std::move(columns_)) {}
  void add_row(const std::vector<double> &values) override { SeriesFile::check_row(name, columns, values); }

 private:
  std::string name;
  std::vector<Column> columns;
};
}  // namespace turgor
