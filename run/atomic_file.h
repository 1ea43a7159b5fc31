// A file that is there whole or not at all: written beside its place, synchronised to
// disk, then renamed over the old one. Survives kill -9 and loss of power.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace turgor {
/// Throws OutputFailed naming the file and the system's reason; what was there before stays.
void write_atomically(const std::filesystem::path &path, std::string_view bytes);

/// PATH.part, where a file is written before it is renamed to `path`. Throws OutputFailed where somebody's
/// link is in the way: it is not followed.
std::filesystem::path temporary_of(const std::filesystem::path &path);

/// The whole file; throws std::runtime_error naming it when it cannot be read.
std::string read_whole(const std::filesystem::path &path);
}  // namespace turgor
