#include "micro/cells/wall_parameters.h"

#include "micro/cells/cell_entry.h"
#include "run/input_entries.h"

namespace turgor {
void WallParameters::declare_wall(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Wall stiffness", wall_stiffness,
                    "G t0, shear modulus times wall thickness (thesis 3.2); of an incompressible wall with "
                    "Young's modulus E it is E t0/3. Units: N/m.",
                    Double(1e-6, 1e9));
  prm.add_parameter("Wall thickness", wall_thickness,
                    "Thickness t0 of the wall, which gives it its mass and bending stiffness; Wall stiffness "
                    "contains it already. Units: m.",
                    Double(1e-10, 1e-3));
  prm.add_parameter("Wall density", wall_density,
                    "Mass of the wall over its volume. Quasi-static loading may take a larger one than the "
                    "wall's: longer steps, same equilibrium. Units: kg/m^3.",
                    Double(1., 1e7));
  prm.add_parameter("Wall beta", wall_beta,
                    "Axial over hoop stress of the wall of a cell in 2D (thesis Eq. 3.5), 0.5 of a cylinder, "
                    "1 of a cube. Units: 1.",
                    Double(0., 1.));
  prm.add_parameter("Wall bending", wall_bending,
                    "Whether the wall has the bending stiffness of its own thickness (in 2D E t0^3/12 with E "
                    "= 4 G). Without it slack walls have no resistance. "
                    "Units: true or false.",
                    Bool());
}

void WallParameters::check_wall() const {
  require_cell_entry(wall_stiffness > 0., "Wall stiffness", wall_stiffness, "positive (N/m)");
  require_cell_entry(wall_thickness > 0., "Wall thickness", wall_thickness, "positive (m)");
  require_cell_entry(wall_density > 0., "Wall density", wall_density, "positive (kg/m^3)");
  require_cell_entry(wall_beta >= 0. && wall_beta <= 1., "Wall beta", wall_beta, "between 0 and 1");
}

void declare_yield(InputEntries &prm, WallYield &yield) {
  using namespace Patterns;
  prm.add_parameter("Yield sharpness", yield.sharpness,
                    "A of Eq. 3.8, the higher, the sooner the wall gives way: half of what it loses is lost "
                    "at a stretch of 1 + 1/A. Cells in 2D only. Units: 1.",
                    Double(1e-3, 1e4));
  prm.add_parameter("Yield drop", yield.drop,
                    "B of Eq. 3.8, the share of the stiffness that a wall loses by yielding at large "
                    "stretch; 0: it does not yield. Units: 1.",
                    Double(0., 1.));
}
}  // namespace turgor
