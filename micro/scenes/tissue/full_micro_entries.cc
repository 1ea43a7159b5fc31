// What an input of full_micro says, and what of it cannot be.
#include "micro/cells/parenchyma.h"
#include "micro/cells/sph_cell_entries.h"
#include "micro/cells/structured_block.h"
#include "micro/scenes/shared_entries.h"
#include "micro/scenes/tissue/full_micro.h"
#include "run/entry_marks.h"
#include "run/input_entries.h"

namespace turgor {
void FullMicro::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  declare_block(prm, columns, rows, load);
  prm.add_parameter("End time", end_time,
                    "Simulated time after which the run ends; steps are shortened so that it is a whole "
                    "number of them. Units: s.",
                    Double(1e-9, 10.));
  declare_step_fraction(prm, step_fraction);
  prm.add_parameter(
      "Window", window,
      "Share of the steps that is really run, to time a scene too large to finish; 0 runs all. Units: none.",
      Double(0., 1.));
  declare_surfaces(prm, surfaces);
  prm.add_parameter("Relax steps", relax_steps,
                    "Damped steps before t = 0 in which the surfaces come to rest, with Surfaces = free or "
                    "osmosis. Units: steps.",
                    Integer(0, 100000000));
  prm.add_parameter("Samples", samples,
                    free_to_change("Number of equal parts of the run after each of which probe.csv and "
                                   "energy.csv get a row. Units: none."),
                    Integer(1, 1000000));
  prm.add_parameter("Frames", frames,
                    free_to_change("Number of equal parts of the run after each of which the particles are "
                                   "written for ParaView and pictures; 0: never. Units: none."),
                    Integer(0, 100000));
  declare_checkpoints(prm, checkpoints);
  prm.enter_subsection("Structure");
  structure.add_parameters(prm);
  prm.leave_subsection();
  declare_sph_cell(prm, cell, sph);
}

void FullMicro::check() const {
  if (double(columns) * rows * sph.particles_per_side * sph.particles_per_side > 2e8)
    throw InputError(
        "Columns x Rows x Particles per side^2 is more than 2e8 particles: choose a smaller block.");
  check_sph_cell(cell, sph);
  load.check();
  check_block(structure, cell, rows);
}

CellLayout FullMicro::laid_out() const {
  return structure.square() ? make_parenchyma(cell, columns, rows, true, true)
                            : turgid_block(structure, cell, columns, rows);
}
}  // namespace turgor
