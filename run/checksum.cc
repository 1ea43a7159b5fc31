#include "run/checksum.h"

#include <boost/crc.hpp>

namespace turgor {
std::uint32_t crc32(const std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::uint64_t fnv1a(const std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ull;
  return hash;
}

std::string hexadecimal(std::uint64_t value) {
  std::string digits(16, '0');
  for (int place = 15; place >= 0; --place, value >>= 4)
    digits[static_cast<std::size_t>(place)] = "0123456789abcdef"[value & 15u];
  return digits;
}
}  // namespace turgor
