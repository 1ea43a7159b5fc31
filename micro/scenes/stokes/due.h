// What happens `times` times, evenly spread over a run until `end` (s), of steps of any length.
#pragma once

#include <cstdint>

namespace turgor {
/// Whether it is due at `now` (s); `next` is the number of the next one, from 1 on, and counts on here.
inline bool is_due(std::uint64_t &next, const unsigned int times, const double now, const double end) {
  const auto passed = [&] { return now >= end * double(next) / times * (1. - 1e-12); };
  if (times == 0 || !passed()) return false;
  while (passed()) ++next;
  return true;
}
}  // namespace turgor
