#include "micro/cells/parenchyma_parameters.h"

#include "micro/cells/cell_entry.h"
#include "run/input_entries.h"

namespace turgor {
void ParenchymaParameters::add_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Period", period, "Side L of the inflated cell. Units: m.", Double(1e-7, 1e-2));
  prm.add_parameter(
      "Depth", depth,
      "Depth z0 of the slab of tissue out of the plane; forces and masses are proportional to it. Units: m.",
      Double(1e-8, 1e-1));
  prm.add_parameter("Nodes per side", nodes_per_side,
                    "Wall nodes per cell side; a cell has four times as many. Units: 1.", Integer(2, 1000));
  declare_wall(prm);
  prm.add_parameter("Lamella ratio", lamella_ratio,
                    "Stiffness of a middle-lamella tie over that of one wall spring at rest. Units: 1.",
                    Double(1e-3, 1e6));
  declare_fluid(prm);
}

void ParenchymaParameters::check() const {
  require_cell_entry(period > 0., "Period", period, "a positive length in m");
  require_cell_entry(depth > 0., "Depth", depth, "a positive length in m");
  require_cell_entry(nodes_per_side >= 2, "Nodes per side", nodes_per_side, "at least 2");
  check_wall();
  require_cell_entry(wall_thickness < 0.5 * period, "Wall thickness", wall_thickness,
                     "positive and thinner than half the period (m)");
  require_cell_entry(lamella_ratio > 0., "Lamella ratio", lamella_ratio, "positive");
  check_fluid();
}
}  // namespace turgor
