#include "micro/scenes/matrix/invasion.h"
#include "run/input_entries.h"

namespace turgor {
void Invasion::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Cells", entries.trial.cells,
                    "Number of cells of the colony, which lie beside each other as close as spheres of their "
                    "size do in a plane. Units: none.",
                    Integer(1, 100000));
  prm.add_parameter("Seed", seed, "Seed of the network and of all that is random of the cells. Units: none.",
                    Integer(1, 1000000));
  prm.add_parameter("End time", end_time, "Time for which the colony is followed. Units: s.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Samples", samples, "Number of rows of history.csv beside the first. Units: none.",
                    Integer(1, 100000));
  prm.add_parameter("Frames", frames,
                    "Number of pictures of cells and network for ParaView, one at the start; 0: none. Units: "
                    "none.",
                    Integer(0, 1000));
  entries.declare(prm);
}

void Invasion::check() const { entries.check(); }
}  // namespace turgor
