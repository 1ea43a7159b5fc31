#include "micro/scenes/shared_entries.h"

#include "micro/cells/block_load.h"
#include "micro/cells/sph_parenchyma.h"
#include "run/input_entries.h"
#include "run/entry_marks.h"
#include "run/number_text.h"
#include "run/run_context.h"

namespace turgor {

void declare_block(InputEntries &prm, unsigned int &columns, unsigned int &rows, BlockLoad &load) {
  prm.add_parameter("Columns", columns,
                    "Number of cells of the block along x, from the clamp to the free side. Units: none.",
                    Patterns::Integer(1, 1000));
  prm.add_parameter("Rows", rows, "Number of cells of the block along y, upwards. Units: none.",
                    Patterns::Integer(1, 1000));
  load.declare(prm);
}

void declare_surfaces(InputEntries &prm, Surfaces &surfaces) {
  prm.add_parameter(
      "Surfaces", surfaces,
      "frozen: the missing neighbours' reference forces stay; free: turgid cells bulge, fixed mass; "
      "osmosis: free, turgor restored; slab: periodic in y. Units: none.");
}

void declare_step_fraction(InputEntries &prm, double &step_fraction) {
  prm.add_parameter("Step fraction", step_fraction,
                    "Time step over the largest that is stable by the stiffnesses of all forces; smaller is "
                    "more accurate and slower. Units: none.",
                    Patterns::Double(0.01, 1.));
}

void declare_substeps(InputEntries &prm, unsigned int &substeps) {
  prm.add_parameter("Substeps", substeps,
                    "Steps of walls and lamella within one step of the fluid (r-RESPA); 1: the same step for "
                    "all. Units: none.",
                    Patterns::Integer(1, 1000));
}

void check_substeps(const unsigned int substeps, const SphParameters &sph) {
  if (substeps > 1 && sph.formulation == SphFormulation::thesis)
    throw InputError("Substeps is " + number_text(substeps) +
                     ", but SPH/Formulation = thesis carries its density along with "
                     "every move of a particle; it has to be 1.");
}

void declare_checkpoints(InputEntries &prm, unsigned int &checkpoints) {
  prm.add_parameter(
      "Checkpoints", checkpoints,
      free_to_change(
          "Number of checkpoints, evenly over the run, from which --resume goes on; 0: none. Units: none."),
      Patterns::Integer(0, 100000));
}
}  // namespace turgor
