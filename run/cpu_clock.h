// CPU time (s) that the calling thread, or the whole process with all its threads, has used so far.
// The difference of two readings is the cost of what lies between; wall time does not tell it on a busy machine.
#pragma once

#include <ctime>

namespace turgor
{
inline double thread_cpu_seconds()
{
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

inline double process_cpu_seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}
} // namespace turgor
