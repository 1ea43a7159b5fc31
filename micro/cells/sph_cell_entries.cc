#include "micro/cells/sph_cell_entries.h"

#include "run/input_entries.h"

#include <stdexcept>

namespace turgor {
void declare_sph_cell(InputEntries &prm, ParenchymaParameters &cell, SphParameters &sph) {
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
  prm.enter_subsection("SPH");
  sph.add_parameters(prm);
  prm.leave_subsection();
}

void check_sph_cell(const ParenchymaParameters &cell, const SphParameters &sph) {
  make_parenchyma(cell, 1, 1, true, true);
  sph.check();
  if (!(cell.turgor > 0.))
    throw std::invalid_argument(
        "Cell/Turgor is 0, but cells of SPH fluid need a positive turgor (Pa): they are brought to "
        "rest against it. A hydrostatic fluid (RVE/Fluid, static_lattice) allows 0.");
  if (2. * sph.support_ratio > sph.particles_per_side)
    throw std::invalid_argument(
        "SPH/Support ratio: the kernel's diameter is larger than a cell; use more Particles per "
        "side or a smaller ratio.");
}
}  // namespace turgor
