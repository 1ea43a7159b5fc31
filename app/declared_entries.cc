#include "app/declared_entries.h"

#include "run/input_entries.h"
#include "run/prm_text.h"

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
}  // namespace turgor
