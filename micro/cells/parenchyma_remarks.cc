#include "micro/cells/parenchyma_remarks.h"

#include "micro/cells/parenchyma.h"
#include "run/judged.h"

namespace turgor {
void remark_on_walls(RunContext &context, const ParenchymaParameters &cell) {
  constexpr double far = 2.;  // walls of fruit fail at 1.1 to 1.3
  const double stretch = turgid_wall_stretch(cell);
  if (stretch > far)
    remarked(context, "wall_stretch",
             "Turgor alone stretches the walls to " + number_text(stretch, 3) +
                 " times their length at rest: cells of Cell/Period = " + number_text(cell.period) +
                 " m are " + number_text(cell.period / stretch, 3) +
                 " m long without it, and stresses are those of balloons blown up so far. Stiffer walls "
                 "(Cell/Wall stiffness), less Cell/Turgor or smaller cells stretch less.");
}
}  // namespace turgor
