#include "run/resource_use.h"

#include "run/cpu_clock.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace turgor {
namespace {
/// Of this program only: ru_maxrss is kept across an exec, the kernel's VmHWM is not.
std::uint64_t peak_memory_of_this_program() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) {
      std::istringstream words(line.substr(6));
      std::uint64_t kilobytes = 0;
      if (words >> kilobytes) return kilobytes * 1024u;
    }
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u;
}
}  // namespace

std::uint64_t physical_memory() {
  return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::uint64_t mapped_for_data() {
  std::ifstream file("/proc/self/statm");  // in pages: size, resident, shared, text, lib, data
  std::uint64_t pages[6] = {};
  for (std::uint64_t &one : pages) file >> one;
  return file ? pages[5] * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

ResourceMeter::ResourceMeter()
    : start(std::chrono::steady_clock::now()), cpu_at_start(process_cpu_seconds()) {}

void ResourceMeter::carry(const ResourceUse &earlier_parts) { earlier = earlier_parts; }

ResourceUse ResourceMeter::now() const {
  ResourceUse use = earlier;
  use.wall_time += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  use.cpu_time += process_cpu_seconds() - cpu_at_start;
  use.peak_memory = std::max(use.peak_memory, peak_memory_of_this_program());
  return use;
}
}  // namespace turgor
