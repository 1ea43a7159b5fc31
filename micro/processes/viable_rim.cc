#include "micro/processes/viable_rim.h"

#include "micro/cells/depth_below_surface.h"
#include "micro/terms/outer_cells.h"

namespace turgor {
void ViableRim::change(Interval &now) {
  const Particles<3> &p = now.cells.particles;
  const CellDeath &death = parameters.death;
  now.deep.assign(p.size(), 0);
  if (death.rim == Rim::none) return;
  const OuterCells outer = find_outer_cells(p);
  if (death.from == RimFrom::edge) {
    for (std::size_t i = 0; i < p.size(); ++i)
      now.deep[i] = outer.edge - (p.position(i) - outer.centre).norm() > death.rim_thickness;
    return;
  }
  now.deep = deeper_than(death.rim_thickness, p, outer);
  for (std::size_t i = 0; i < p.size(); ++i)
    now.deep[i] = now.deep[i] && now.surroundings.depth_of(p.position(i)) > death.rim_thickness;
}
}  // namespace turgor
