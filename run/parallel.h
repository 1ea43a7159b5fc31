// Loops over ranges, shared out over threads in chunks that do not depend on their number, and sums over such
// chunks in their order: same bits on any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace turgor {
/// Chunks of a range of n that are worth a thread's while.
struct Chunks {
  std::size_t n, size;
  explicit Chunks(const std::size_t n_, const std::size_t size_ = 512) : n(n_), size(size_) {}
  std::size_t count() const { return (n + size - 1) / size; }
  std::size_t begin(const std::size_t c) const { return c * size; }
  std::size_t end(const std::size_t c) const { return std::min(n, (c + 1) * size); }
};

/// body(begin, end) for all chunks of [0, n).
template <class Body>
void for_chunks(const unsigned int threads, const Chunks &chunks, const Body &body) {
  if (threads <= 1 || chunks.count() <= 1)
    for (std::size_t c = 0; c < chunks.count(); ++c) body(chunks.begin(c), chunks.end(c));
  else
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks.count()),
                      [&](const tbb::blocked_range<std::size_t> &r) {
                        for (std::size_t c = r.begin(); c < r.end(); ++c)
                          body(chunks.begin(c), chunks.end(c));
                      });
}

/// Sum of body(begin, end) over all chunks, in their order.
template <class Body>
double sum_chunks(const unsigned int threads, const Chunks &chunks, std::vector<double> &parts,
                  const Body &body) {
  parts.resize(chunks.count());
  for_chunks(threads, chunks,
             [&](std::size_t begin, std::size_t end) { parts[begin / chunks.size] = body(begin, end); });
  double total = 0.;
  for (const double part : parts) total += part;
  return total;
}
}  // namespace turgor
