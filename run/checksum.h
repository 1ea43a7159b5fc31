// Checksums of files and inputs: CRC-32 (IEEE 802.3) finds a torn or damaged checkpoint,
// FNV-1a (64 bit) names an input, for resume and for the cache of a study.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace turgor {
std::uint32_t crc32(std::string_view bytes);
std::uint64_t fnv1a(std::string_view bytes);
std::string hexadecimal(std::uint64_t value);  ///< 16 digits
}  // namespace turgor
