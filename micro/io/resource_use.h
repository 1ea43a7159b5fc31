// What a run has cost: wall time and CPU time (s) of this process and its children, and
// the largest memory it held (bytes). A resumed run carries the cost of its earlier parts.
#pragma once

#include <chrono>
#include <cstdint>

namespace turgor
{
struct ResourceUse
{
  double wall_time = 0., cpu_time = 0.; ///< s
  std::uint64_t peak_memory = 0;        ///< bytes
};

/// Of this machine, bytes.
std::uint64_t physical_memory();
/// Mapped by this process for data, held or not, bytes; 0 where the system does not tell.
std::uint64_t mapped_for_data();

class ResourceMeter
{
public:
  ResourceMeter();
  void carry(const ResourceUse &earlier_parts);
  ResourceUse now() const;

private:
  std::chrono::steady_clock::time_point start;
  ResourceUse earlier;
};
} // namespace turgor
