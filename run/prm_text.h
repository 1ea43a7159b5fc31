// The text of a .prm file as a list of settings, each with the line it stands on:
//   set NAME = VALUE, subsection NAME ... end, comments from # to the end of the line, a
//   trailing \ continues a line.
// deal.II's own parser is not used for reading, because it stops at the first wrong entry
// without its neighbours' names, and takes an entry set twice in silence.
#pragma once

#include "run/user_text.h"

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
struct PrmSetting {
  std::vector<std::string> section;  ///< outermost first
  std::string name, value;
  std::string where;  ///< "FILE, line 12" or "--set 'Name=value'"

  std::string path() const;  ///< "Section/Name"
};

struct PrmSection {
  std::vector<std::string> path;
  std::string where;
};

struct PrmText {
  std::vector<PrmSetting> settings;  ///< in the order of the file
  std::vector<PrmSection> sections;  ///< every `subsection` line, also of empty ones
};

/// Throws InputError with file and line of every line that is none of the above, for unbalanced subsections
/// and for those that are nested deeper than any scene's.
PrmText parse_prm(const std::string &text, const std::string &file_name);

/// Reads the file; throws InputError when it is missing, a directory or not text in UTF-8.
PrmText read_prm(const std::filesystem::path &file);

/// "Section/Name=value" of --set, or of what else messages call `source`.
PrmSetting parse_override(const std::string &text, const std::string &source = "--set");

std::string join_path(const std::vector<std::string> &section, const std::string &name);
}  // namespace turgor
