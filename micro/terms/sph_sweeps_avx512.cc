// The sweeps for processors with AVX-512 (eight lanes); compiled with wider flags than the rest.
#include "micro/terms/sph_sweeps.inc.h"

namespace turgor::sph
{
const Sweeps &sweeps_avx512()
{
  static const Sweeps chosen{&density_any, &force_any, "8 lanes"};
  return chosen;
}
} // namespace turgor::sph
