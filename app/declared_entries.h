// A list of declared entries as text: the commented .prm that `turgor parameters` prints.
#pragma once

#include "run/input_entries.h"

#include <string>
#include <vector>

namespace turgor {
/// A commented .prm text of the entries; with_defaults: their defaults, else their values.
std::string prm_of(const std::vector<InputEntry> &entries, bool with_defaults, bool with_comments);
}  // namespace turgor
