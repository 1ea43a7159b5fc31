#include "run/archive.h"

#include "run/number_text.h"

namespace turgor {
namespace {
constexpr std::size_t size_bytes = sizeof(std::uint64_t);
}

Archive::Archive(const std::string_view bytes_) : is_loading(true), bytes(bytes_), end(bytes_.size()) {}

void Archive::section(const std::string &next) {
  close();
  name = next;
  auto length = static_cast<unsigned char>(name.size());
  std::uint64_t size = 0;
  opened = saved.size();
  end = bytes.size();
  raw(&size, size_bytes);
  raw(&length, 1);
  std::string there = name;
  there.resize(length);
  raw(there.data(), length);
  if (!is_loading) return;
  if (there != name) {
    for (char &letter : there) letter = letter >= ' ' && letter <= '~' ? letter : '?';
    throw ArchiveError("The checkpoint has a section '" + there + "' where this program reads '" + name +
                       "': it is of another layout, or damaged.");
  }
  require(size, 1);
  end = at + size;
}

void Archive::close() {
  if (is_loading && !name.empty() && at != end)
    throw ArchiveError("The checkpoint holds more" + where() +
                       " than this program reads: it is of another layout, or damaged.");
  if (is_loading || name.empty()) return;
  const std::uint64_t size = saved.size() - opened - size_bytes - 1 - name.size();
  std::memcpy(saved.data() + opened, &size, size_bytes);
}

void Archive::append(const std::string_view more) {
  close();
  name.clear();
  saved.append(more);
}

std::string Archive::finish() {
  close();
  name.clear();
  if (is_loading && at != bytes.size())
    throw ArchiveError(
        "The checkpoint holds more than this program reads: it is of another layout, or damaged.");
  return std::move(saved);
}

void Archive::flag(bool &value) {
  char byte = value;
  raw(&byte, 1);
  if (is_loading && byte != 0 && byte != 1)
    throw ArchiveError("The checkpoint holds" + where() +
                       " neither yes nor no where one is read: it is of another layout, or damaged.");
  value = byte == 1;
}

std::string Archive::where() const { return name.empty() ? "" : " in its section '" + name + "'"; }

void Archive::too_early() const {
  throw ArchiveError("The checkpoint ends too early" + where() + ": it is of another layout, or damaged.");
}

void Archive::other_size(const std::uint64_t there, const std::size_t here) const {
  throw ArchiveError("The checkpoint belongs to another mesh or scene: it holds " + number_text(there) +
                     " entries" + where() + " where this run has " + number_text(here) + ".");
}
}  // namespace turgor
