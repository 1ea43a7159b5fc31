// The portable sweeps (four lanes; the project's base instruction set).
#include "micro/terms/sph_sweeps.inc.h"

namespace turgor::sph
{
const Sweeps &sweeps_avx2()
{
  static const Sweeps chosen{&density_any, &force_any, "4 lanes"};
  return chosen;
}
} // namespace turgor::sph
