// From the entries of an input to what a run is (run_identity.h): which decide, which end it, which only say
// what is written (entry_marks.h), and the files they name (word_or_file.h).
//   RunIdentity identity = identity_of(entries, find_files(entries, "my/input.prm"));
#pragma once

#include "run/input_entries.h"
#include "run/run_identity.h"

#include <filesystem>
#include <vector>

namespace turgor {
/// The files that entries name, looked up beside the input file first, then in the working directory. The
/// entries' variables get the place where each was found; one that is nowhere is left to the scene, which
/// says what it misses.
std::vector<RunIdentity::NamedFile> find_files(InputEntries &entries, const std::filesystem::path &input);

RunIdentity identity_of(const InputEntries &entries, std::vector<RunIdentity::NamedFile> files);
}  // namespace turgor
