// The sweeps for processors with AVX-512 (eight lanes); compiled with wider flags than the rest.
#include "micro/terms/sph_sweeps.inc.h"

namespace turgor::sph {
template <int dim>
const Sweeps<dim> &sweeps_avx512() {
  static const Sweeps<dim> chosen{&density_any<dim>, &force_any<dim>, &viscosity<dim>, rays_of<dim>(),
                                  "avx512"};
  return chosen;
}

template const Sweeps<2> &sweeps_avx512<2>();
template const Sweeps<3> &sweeps_avx512<3>();
}  // namespace turgor::sph
