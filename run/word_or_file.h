// The pattern of an entry whose value is one of a few words or else the name of a file. By it the program
// knows which entries name files: their bytes belong to what a run is, they are looked up beside the input
// file first (then in the working directory) and copied into the output directory.
//   entries.add_parameter("Local stiffness", stiffness, "...", Patterns::WordOrFile("none|closest"));
#pragma once

#include "run/entry_pattern.h"

#include <algorithm>
#include <string>

namespace turgor {
namespace Patterns {
inline EntryPattern WordOrFile(const std::string &words)  ///< "a|b|c"
{
  EntryPattern pattern = Selection(words);
  pattern.kind = EntryPattern::Kind::text;
  return pattern;
}
}  // namespace Patterns

/// Whether this value of such an entry names a file.
inline bool names_file(const EntryPattern &pattern, const std::string &value) {
  return pattern.kind == EntryPattern::Kind::text && !pattern.choices.empty() &&
         std::find(pattern.choices.begin(), pattern.choices.end(), value) == pattern.choices.end();
}
}  // namespace turgor
