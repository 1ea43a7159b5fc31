// The sentences for what is wrong with an entry of an input: where it stands, what is allowed, what was most
// likely meant.
#pragma once

#include "run/input_entries.h"
#include "run/mistakes.h"
#include "run/prm_text.h"

#include <string>
#include <vector>

namespace turgor {
/// Sections and entries that are not known, values that are not allowed and entries set twice. Gives back the
/// settings that are right.
std::vector<PrmSetting> right_settings(const PrmText &text, const std::vector<InputEntry> &known,
                                       Mistakes &mistakes);

void find_repeated(const PrmText &text, Mistakes &mistakes);

/// What a scene says of values that do not go together, after where those that it names were set: lines of
/// the file or --set. Where it names none of them, after the file and every --set.
std::string with_place(const std::string &sentence, const std::string &file,
                       const std::vector<PrmSetting> &in_file, const std::vector<PrmSetting> &overrides,
                       const std::vector<InputEntry> &known);
}  // namespace turgor
