#include "micro/cells/block_load.h"

#include "run/input_entries.h"
#include "run/run_context.h"

#include <cmath>

namespace turgor {
void BlockLoad::declare(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Load", size,
                    "Body force as the stress it would make at the clamp: tissue density times body force "
                    "times width. Units: Pa.",
                    Double(-1e8, 1e8));
  prm.add_parameter("Direction", direction,
                    "Direction in which the body force acts, of any length. Units: 1.", List(Double(), 2, 2));
  prm.add_parameter("Traction", traction,
                    "Force per reference area on the right side of the block: normal to it, and along it. "
                    "Units: Pa.",
                    List(Double(-1e8, 1e8), 2, 2));
}

void BlockLoad::check() const {
  if (!(direction.norm() > 0.) || !std::isfinite(direction.norm()))
    throw InputError("Direction must be two finite numbers that are not both 0, such as '0, -1'.");
}

Vector<2> BlockLoad::acceleration(const double density, const double width) const {
  return size / (density * width) / direction.norm() * direction;
}

Vector<2> BlockLoad::along() const {
  const Vector<2> push = size / direction.norm() * direction + traction;
  return push.norm() > 0. ? Vector<2>(push / push.norm()) : Vector<2>(0., -1.);
}
}  // namespace turgor
