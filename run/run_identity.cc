#include "run/run_identity.h"

#include "run/checksum.h"

#include <algorithm>

namespace turgor {
namespace {
std::string lines(const RunIdentity::Entries &entries) {
  std::string text;
  for (const auto &[path, value] : entries) text += path + " = " + value + "\n";
  return text;
}
}  // namespace

std::string RunIdentity::input_hash() const {
  return hexadecimal(fnv1a(lines(deciding) + lines(ends) + lines(free)));
}

std::string RunIdentity::state_hash() const { return hexadecimal(fnv1a(lines(deciding) + program)); }

std::string RunIdentity::hash() const { return hexadecimal(fnv1a(input_hash() + " " + program)); }

std::string difference(const RunIdentity::Entries &before, const RunIdentity::Entries &now) {
  const auto value_in = [](const RunIdentity::Entries &entries, const std::string &path) {
    const auto there =
        std::find_if(entries.begin(), entries.end(), [&](const auto &entry) { return entry.first == path; });
    return there == entries.end() ? std::string("not there") : there->second;
  };
  for (const RunIdentity::Entries *entries : {&now, &before})
    for (const auto &[path, ignored] : *entries)
      if (const std::string old = value_in(before, path), value = value_in(now, path); old != value)
        return "'" + path + "' was " + old + " and is " + value;
  return "";
}
}  // namespace turgor
