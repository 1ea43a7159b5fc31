// The sweeps without a word of any processor: four lanes by the compiler's own vectors.
#define TURGOR_PORTABLE_LANES
#include "micro/terms/sph_sweeps.inc.h"

namespace turgor::sph {
template <int dim>
const Sweeps<dim> &sweeps_portable() {
  static const Sweeps<dim> chosen{&density_any<dim>, &force_any<dim>, &viscosity<dim>, rays_of<dim>(),
                                  "portable"};
  return chosen;
}

template const Sweeps<2> &sweeps_portable<2>();
template const Sweeps<3> &sweeps_portable<3>();
}  // namespace turgor::sph
