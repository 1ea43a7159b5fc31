// A list of declared entries as text: the commented .prm that `turgor parameters` prints.
#pragma once

#include "run/input_entries.h"

#include <string>
#include <vector>

namespace turgor {
/// A commented .prm text of the entries; with_defaults: their defaults, else their values.
std::string prm_of(const std::vector<InputEntry> &entries, bool with_defaults, bool with_comments);

/// The entries of a subsection, or one entry, by its path ("Cell", "Cell/Turgor"). Throws InputError where
/// there is neither.
std::vector<InputEntry> part_of(const std::vector<InputEntry> &entries, const std::string &part);
}  // namespace turgor
