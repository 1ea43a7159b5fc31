#include "micro/engine/table.h"

#include "run/archive.h"

namespace turgor {
void Table::resize(const std::size_t n) {
  rows = n;
  for (auto &[name, column] : columns) std::visit([n](auto &values) { values.resize(n); }, column);
}

std::vector<std::string> Table::names() const {
  std::vector<std::string> result;
  for (const auto &[name, column] : columns) result.push_back(name);
  return result;
}

void Table::gather(const Rearrangement &places) {
  rows = places.size();
  for (auto &[name, column] : columns)
    std::visit([&places](auto &values) { values = places.of(values); }, column);
}

void Table::archive(Archive &a) {
  std::uint64_t n = rows;
  std::vector<std::string> there = names();
  a(n, there);
  if (there != names())
    throw ArchiveError("The checkpoint does not belong to this scene: its fields are others.");
  rows = n;
  for (auto &[name, column] : columns)
    if (std::visit([&a](auto &values) { return a(values), values.size(); }, column) != rows)
      throw ArchiveError("The checkpoint holds a field " + name + " of another length than its others.");
}
}  // namespace turgor
