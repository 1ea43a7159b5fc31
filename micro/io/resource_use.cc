#include "micro/io/resource_use.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace turgor
{
namespace
{
double seconds(const timeval &time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}
} // namespace

std::uint64_t physical_memory()
{
  return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::uint64_t mapped_for_data()
{
  std::ifstream file("/proc/self/statm"); // in pages: size, resident, shared, text, lib, data
  std::uint64_t pages[6] = {};
  for (std::uint64_t &one : pages)
    file >> one;
  return file ? pages[5] * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

ResourceMeter::ResourceMeter()
  : start(std::chrono::steady_clock::now())
{}

void ResourceMeter::carry(const ResourceUse &earlier_parts)
{
  earlier = earlier_parts;
}

ResourceUse ResourceMeter::now() const
{
  ResourceUse use = earlier;
  use.wall_time += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN})
    {
      rusage usage = {};
      getrusage(who, &usage);
      use.cpu_time += seconds(usage.ru_utime) + seconds(usage.ru_stime);
      use.peak_memory = std::max(use.peak_memory, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u);
    }
  return use;
}
} // namespace turgor
