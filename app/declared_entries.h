// A list of declared entries as text: the commented .prm that `turgor parameters` prints, and the canonical lines an
// input's hash is made of.
#pragma once

#include "micro/io/input_entries.h"

#include <string>
#include <vector>

namespace turgor
{
/// A commented .prm text of the entries; with_defaults: their defaults, else their values.
std::string prm_of(const std::vector<InputEntry> &entries, bool with_defaults, bool with_comments);

/// "section/name = value" per line, numbers in one spelling: what the input hash is made of.
std::string canonical(const std::vector<InputEntry> &entries);
} // namespace turgor
