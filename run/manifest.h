// Which files of an output directory this program made, so that a new run into the same directory replaces
// those and never anything a person put there. DIR/made_by_turgor.txt, one path relative to DIR per line.
//   claim("runs/slab", "probe.csv");   // then make it
#pragma once

#include <filesystem>
#include <string>

namespace turgor {
/// Enters a file or folder that is to be made. Throws InputError when something is there that this program
/// did not make, or when a symbolic link stands in its way: what it points to is somebody's.
void claim(const std::filesystem::path &directory, const std::string &relative_path);

/// Enters what has been made already. A name is kept once.
void record_made(const std::filesystem::path &directory, const std::string &relative_path);

/// The refusals of claim() alone.
void require_claimable(const std::filesystem::path &directory, const std::string &relative_path);

bool is_made(const std::filesystem::path &directory, const std::string &relative_path);

/// Removes every recorded file (and recorded folders that have become empty); the number removed.
std::size_t remove_made(const std::filesystem::path &directory);

/// Moves every recorded file, the record first, so that an interrupted move can be taken up by move_back();
/// the number moved.
std::size_t move_made(const std::filesystem::path &from, const std::filesystem::path &to);

/// Moves everything under `from` back to where move_made() took it from, the record last. What stands in the
/// way stays.
void move_back(const std::filesystem::path &from, const std::filesystem::path &to);
}  // namespace turgor
