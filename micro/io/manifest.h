// Which files of an output directory this program made, so that a new run into the same
// directory removes those and never anything a person put there. DIR/made_by_turgor.txt,
// one path relative to DIR per line.
#pragma once

#include <filesystem>
#include <string>

namespace turgor
{
/// Before the file is made. A name is kept once.
void record_made(const std::filesystem::path &directory, const std::string &relative_path);

/// Removes every recorded file (and recorded folders that have become empty); the number removed.
std::size_t remove_made(const std::filesystem::path &directory);
} // namespace turgor
