// Named columns of one length: what is kept for each of many particles, cells, edges or triangles beside what
// all of them have. Columns are declared by whoever needs them when a scene is put together, so that a scene
// carries what it uses; all are rearranged, saved and loaded by one routine.
//
//   Table cells;  cells.resize(100);  cells.declare("phase");  cells.column("phase")[3] = 0.5;
//                 cells.declare<std::uint64_t>("id");
//
// Types of a column: double (the usual), std::uint64_t, std::uint8_t. Units are those of whoever declares it
// (SI). A new place is zero.
#pragma once

#include "micro/engine/rearrangement.h"

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace turgor {
class Archive;

class Table {
 public:
  std::size_t size() const { return rows; }
  void resize(std::size_t n);

  /// Makes a column (once). Throws std::logic_error where one of another type has that name.
  template <class T = double>
  void declare(const std::string &name) {
    columns.try_emplace(name, std::vector<T>(rows));
    column<T>(name);
  }

  bool has(const std::string &name) const { return columns.count(name) > 0; }

  /// Throws std::logic_error for a column that nobody declared, or declared with another type. The reference
  /// stays good for as long as the table.
  template <class T = double>
  std::vector<T> &column(const std::string &name) {
    const auto found = columns.find(name);
    std::vector<T> *const values =
        found == columns.end() ? nullptr : std::get_if<std::vector<T>>(&found->second);
    if (values == nullptr)
      throw std::logic_error("the field '" + name + "' was not declared, or as one of another type");
    return *values;
  }
  template <class T = double>
  const std::vector<T> &column(const std::string &name) const {
    return const_cast<Table *>(this)->column<T>(name);
  }

  std::vector<std::string> names() const;  ///< in alphabetical order

  void gather(const Rearrangement &places);

  /// Columns have to be declared before loading; the number of rows is that of the checkpoint. Throws
  /// ArchiveError for one with other columns.
  void archive(Archive &a);

 private:
  std::size_t rows = 0;
  std::map<std::string,
           std::variant<std::vector<double>, std::vector<std::uint64_t>, std::vector<std::uint8_t>>>
      columns;
};
}  // namespace turgor
