// What the life of centre-based cells depends on (cell_life.h), and what of it is a cell's own for life:
// drawn by its id. In: m, s, Pa. Each law says more in its own file.
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/laws/cell_cycle.h"
#include "micro/laws/cell_death.h"
#include "micro/laws/cell_variability.h"
#include "micro/laws/cell_volume.h"
#include "micro/processes/cell_division.h"

namespace turgor {
struct CellLifeParameters {
  double birth_radius = 6e-6;       ///< m, uncompressed
  double cycle_time = 17. * 3600.;  ///< mean T, s
  double modulus = 450.;            ///< mean Young's E of the contacts, Pa
  double poisson = 0.4;
  double bulk_modulus = 5e3;       ///< mean K_0, Pa
  double relaxation = 2. * 3600.;  ///< T_rel, s
  CellVolumeLaw volume;
  GrowthLaw growth;
  CellCycle cycle;
  CellDeath death;
  CellDivision division;
  CellVariability variability;

  double birth_volume() const { return sphere_volume(birth_radius); }  ///< m^3

  /// Cycle time, bulk modulus and modulus of the contacts of cell i, which depend on its id.
  void draw(CellPopulation &cells, const std::size_t i) const {
    const std::uint64_t id = cells.id()[i];
    Particles<3> &p = cells.particles;
    p.cells.column("cycle_time")[i] = variability(cycle_time, id, Varied::cycle_time);
    p.cells.column("bulk_modulus")[i] = variability(bulk_modulus, id, Varied::bulk_modulus);
    p.field("modulus")[i] = variability(modulus, id, Varied::modulus) / (1. - poisson * poisson);
  }
};
}  // namespace turgor
