#include "micro/terms/sph_sweeps.h"

#include <cstdlib>
#include <string_view>

namespace turgor::sph
{
const Sweeps &sweeps()
{
  static const Sweeps &chosen = [] () -> const Sweeps & {
    const char *wish = std::getenv("TURGOR_SIMD");
    const bool narrow = wish != nullptr && std::string_view(wish) == "avx2";
    if (!narrow && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
      return sweeps_avx512();
    return sweeps_avx2();
  }();
  return chosen;
}
} // namespace turgor::sph
