#include "app/input_identity.h"

#include "app/program_build.h"
#include "run/atomic_file.h"
#include "run/checksum.h"
#include "run/entry_marks.h"
#include "run/number_text.h"
#include "run/prm_text.h"
#include "run/word_or_file.h"

#include <algorithm>

namespace turgor {
namespace {
/// The value, numbers in one spelling.
std::string canonical_value(const InputEntry &entry) {
  const std::string value = trimmed(entry.value);
  return entry.pattern.kind == EntryPattern::Kind::number ? exact_text(*read_number(value)) : value;
}

bool says(const InputEntry &entry, const char *words) {
  return entry.documentation.find(words) != std::string::npos;
}
}  // namespace

std::vector<RunIdentity::NamedFile> find_files(InputEntries &entries, const std::filesystem::path &input) {
  std::vector<RunIdentity::NamedFile> files;
  for (const InputEntry &entry : std::vector<InputEntry>(entries.entries()))  // a copy: values change below
  {
    if (!names_file(entry.pattern, trimmed(entry.value))) continue;
    const std::filesystem::path named = trimmed(entry.value),
                                beside = input.parent_path() / named;  // of an absolute one: itself
    const std::filesystem::path &file = std::filesystem::is_regular_file(beside) ? beside : named;
    if (!std::filesystem::is_regular_file(file)) continue;
    std::string name = file.filename().string();
    if (std::any_of(files.begin(), files.end(), [&](const auto &other) { return other.name == name; }))
      name = number_text(files.size()) + "_" + name;
    files.push_back({entry.path(), name, read_whole(file)});
    for (const std::string &part : entry.section) entries.enter_subsection(part);
    entries.set(entry.name, file.string());
    for (std::size_t i = 0; i < entry.section.size(); ++i) entries.leave_subsection();
  }
  return files;
}

RunIdentity identity_of(const InputEntries &entries, std::vector<RunIdentity::NamedFile> files) {
  RunIdentity identity;
  identity.program = program_build().hash;
  for (const InputEntry &entry : entries.entries()) {
    std::string value = canonical_value(entry);
    for (const RunIdentity::NamedFile &file : files)
      if (file.entry == entry.path()) value = "a file with the checksum " + hexadecimal(fnv1a(file.bytes));
    (says(entry, free_to_change_words) ? identity.free
     : says(entry, end_of_run_words)   ? identity.ends
                                       : identity.deciding)
        .emplace_back(entry.path(), value);
  }
  identity.files = std::move(files);
  return identity;
}
}  // namespace turgor
