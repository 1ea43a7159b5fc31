// What a run has cost: wall time and CPU time (s) of this process, both from the meter's making, and the
// largest memory it held (bytes). A process keeps the account of whatever it was before an exec (a launcher
// that compiled for minutes): none of that counts. A resumed run carries the cost of its earlier parts.
//   const ResourceMeter meter; work(); meter.now().cpu_time
#pragma once

#include <chrono>
#include <cstdint>

namespace turgor {
struct ResourceUse {
  double wall_time = 0., cpu_time = 0.;  ///< s
  std::uint64_t peak_memory = 0;         ///< bytes
};

/// Of this machine, bytes.
std::uint64_t physical_memory();
/// Mapped by this process for data, held or not, bytes; 0 where the system does not tell.
std::uint64_t mapped_for_data();

class ResourceMeter {
 public:
  ResourceMeter();
  void carry(const ResourceUse &earlier_parts);
  ResourceUse now() const;

 private:
  std::chrono::steady_clock::time_point start;
  double cpu_at_start;  ///< s
  ResourceUse earlier;
};
}  // namespace turgor
