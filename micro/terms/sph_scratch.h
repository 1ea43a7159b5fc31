// Aligned memory of one thread, grown to the largest cell it met.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace turgor {
class SphScratch {
 public:
  static std::size_t round_up(const std::size_t doubles) { return (doubles + 7) / 8 * 8; }
  /// 64-byte aligned; what was in it is lost when it grows.
  double *get(std::size_t doubles) {
    if (doubles > size) {
      size = doubles + doubles / 2;
      memory.reset(static_cast<double *>(std::aligned_alloc(64, (size * sizeof(double) + 63) / 64 * 64)));
      if (!memory) throw std::bad_alloc();
    }
    return memory.get();
  }

 private:
  struct Free {
    void operator()(double *p) const { std::free(p); }
  };
  std::unique_ptr<double, Free> memory;
  std::size_t size = 0;
};
}  // namespace turgor
