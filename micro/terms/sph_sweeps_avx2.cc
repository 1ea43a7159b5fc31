// The portable sweeps (four lanes; the project's base instruction set).
#include "micro/terms/sph_sweeps.inc.h"

namespace turgor::sph
{
template <int dim>
const Sweeps<dim> &sweeps_avx2()
{
  static const Sweeps<dim> chosen{&density_any<dim>, &force_any<dim>, "4 lanes"};
  return chosen;
}

template const Sweeps<2> &sweeps_avx2<2>();
template const Sweeps<3> &sweeps_avx2<3>();
} // namespace turgor::sph
