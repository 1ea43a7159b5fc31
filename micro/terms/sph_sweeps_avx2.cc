// The sweeps for processors with AVX2 (four lanes; the instruction set of all other files).
#include "micro/terms/sph_sweeps.inc.h"

namespace turgor::sph {
template <int dim>
const Sweeps<dim> &sweeps_avx2() {
  static const Sweeps<dim> chosen{&density_any<dim>, &force_any<dim>, &viscosity<dim>, rays_of<dim>(),
                                  "avx2"};
  return chosen;
}

template const Sweeps<2> &sweeps_avx2<2>();
template const Sweeps<3> &sweeps_avx2<3>();
}  // namespace turgor::sph
