// What an entry means for a run that goes on (--resume), said where the entry is declared: in its text, so
// that people read it in `turgor parameters`, and by these words, so that the program knows it. Without a
// mark an entry decides the numbers: it has to be the same.
//   prm.add_parameter("Frames", frames, free_to_change("Frames of the field file. Units: none."), ...);
#pragma once

#include <string>

namespace turgor {
inline constexpr const char *free_to_change_words = "It changes no state: --resume takes another value.";
inline constexpr const char *end_of_run_words = "--resume takes a larger value, and the run goes on.";

/// Of an entry that only says what is written and how often.
inline std::string free_to_change(const std::string &text) { return text + " " + free_to_change_words; }

/// Of an entry that says how far the run goes, or into how many equal parts. The scene itself refuses
/// (InputError, in its reading of the checkpoint) an end with which the way up to the checkpoint would have
/// been another.
inline std::string end_of_run(const std::string &text) { return text + " " + end_of_run_words; }
}  // namespace turgor
