#include "app/declared_entries.h"

#include "app/nearest_name.h"
#include "run/input_entries.h"
#include "run/prm_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <sstream>

namespace turgor {
std::string prm_of(const std::vector<InputEntry> &entries, const bool with_defaults,
                   const bool with_comments) {
  std::ostringstream out;
  std::vector<std::string> open;
  const auto indent = [&] { return std::string(2 * open.size(), ' '); };
  for (const InputEntry &entry : entries) {
    std::size_t common = 0;
    while (common < open.size() && common < entry.section.size() && open[common] == entry.section[common])
      ++common;
    while (open.size() > common) {
      open.pop_back();
      out << indent() << "end\n";
    }
    while (open.size() < entry.section.size()) {
      out << (with_comments ? "\n" : "") << indent() << "subsection " << entry.section[open.size()] << "\n";
      open.push_back(entry.section[open.size()]);
    }
    if (with_comments) {
      std::istringstream words(entry.documentation + (entry.documentation.empty() ? "" : " ") +
                               "Allowed: " + entry.pattern.in_words() + ".");
      std::string line = indent() + "#";
      out << "\n";
      for (std::string word; words >> word;) {
        if (line.size() + 1 + word.size() > 100) {
          out << line << "\n";
          line = indent() + "#";
        }
        line += " " + word;
      }
      out << line << "\n";
    }
    out << indent() << "set " << entry.name << " = " << (with_defaults ? entry.default_value : entry.value)
        << "\n";
  }
  while (!open.empty()) {
    open.pop_back();
    out << indent() << "end\n";
  }
  return out.str();
}

std::vector<InputEntry> part_of(const std::vector<InputEntry> &entries, const std::string &part) {
  std::vector<InputEntry> found;
  std::vector<std::string> known;
  for (const InputEntry &entry : entries) {
    const std::string path = entry.path();
    if (path == part || path.starts_with(part + "/")) found.push_back(entry);
    for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', end + 1))
      if (std::find(known.begin(), known.end(), path.substr(0, end)) == known.end())
        known.push_back(path.substr(0, end));
  }
  if (!found.empty()) return found;
  std::vector<std::string> names;
  for (const InputEntry &entry : entries) {
    if (entry.name == part)
      throw InputError("There is no entry '" + part + "' at the top level. Did you mean '" + entry.path() +
                       "'?");
    names.push_back(entry.path());
  }
  names.insert(names.begin(), known.begin(), known.end());
  throw InputError("There is no subsection or entry '" + part + "'." + suggestion(part, names));
}
}  // namespace turgor
