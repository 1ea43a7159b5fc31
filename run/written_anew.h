// A vector of another size whose entries are all written anew: where it has to grow, the old ones are given
// back first and not copied, and there is room for a sixteenth more, not for twice as many. New room holds
// zeros.
#pragma once

#include <cstddef>
#include <vector>

namespace turgor {
template <class T>
void resize_anew(std::vector<T> &values, const std::size_t n) {
  if (values.capacity() < n) {
    std::vector<T>().swap(values);
    values.reserve(n + n / 16);
  }
  values.resize(n);
}
}  // namespace turgor
