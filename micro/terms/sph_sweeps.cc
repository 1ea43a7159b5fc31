#include "micro/terms/sph_sweeps.h"

#include <cstdlib>
#include <string_view>

namespace turgor::sph
{
template <int dim>
const Sweeps<dim> &sweeps()
{
  static const Sweeps<dim> &chosen = [] () -> const Sweeps<dim> & {
    const char *wish = std::getenv("TURGOR_SIMD");
    const bool narrow = wish != nullptr && std::string_view(wish) == "avx2";
    if (!narrow && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
      return sweeps_avx512<dim>();
    return sweeps_avx2<dim>();
  }();
  return chosen;
}

template const Sweeps<2> &sweeps<2>();
template const Sweeps<3> &sweeps<3>();
} // namespace turgor::sph
