// The known name a misspelt one most likely meant: least edit distance, capitals ignored.
#pragma once

#include <string>
#include <vector>

namespace turgor {
/// Levenshtein: the least number of letters inserted, removed or replaced.
unsigned int edit_distance(const std::string &a, const std::string &b);

/// Empty when no known name is near (more than a third of the letters differ, at least two allowed).
std::string nearest_name(const std::string &name, const std::vector<std::string> &known);

/// " Did you mean 'x'?" or, with nothing near, " Known: a, b, c." (cut after a dozen).
std::string suggestion(const std::string &name, const std::vector<std::string> &known);
}  // namespace turgor
