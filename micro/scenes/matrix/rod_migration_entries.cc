#include "micro/scenes/matrix/rod_migration.h"
#include "run/input_entries.h"

namespace turgor {
void RodMigration::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Seeds", seeds, "Number of cells, each in a network of its own. Units: none.",
                    Integer(1, 10000));
  prm.add_parameter("First seed", first_seed, "Seed of the first of them. Units: none.", Integer(1, 1000000));
  prm.add_parameter("End time", end_time, "Time for which each cell is followed. Units: s.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Samples", samples,
                    "Number of rows of paths.csv for each cell, beside its first. Units: none.",
                    Integer(1, 100000));
  prm.add_parameter("Frames", frames,
                    "Number of pictures of the first cell and its network for ParaView, one at the start; 0: "
                    "none. Units: none.",
                    Integer(0, 1000));
  entries.declare(prm);
}

void RodMigration::check() const { entries.check(); }
}  // namespace turgor
