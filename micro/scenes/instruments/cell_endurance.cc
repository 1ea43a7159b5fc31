#include "micro/scenes/instruments/endurance_run.h"

#include "micro/cells/sph_cell_entries.h"
#include "micro/scenes/shared_entries.h"
#include "run/input_entries.h"
#include "run/number_text.h"

#include <cmath>

namespace turgor {
void CellEndurance::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Steps", steps, "Number of time steps of the run, a whole number. Units: steps.",
                    Double(1., 1e12));
  prm.add_parameter("F_dot", F_dot,
                    "Constant rate of the deformation gradient, xx, xy; yx, yy, from F = I. Units: 1/s.",
                    List(List(Double(-1e6, 1e6), 2, 2, ","), 2, 2, ";"));
  prm.add_parameter(
      "Start speed", start_speed,
      "Largest component of random velocities that disturb the cell at the start; 0: none. Units: m/s.",
      Double(0., 100.));
  declare_step_fraction(prm, step_fraction);
  prm.add_parameter(
      "Samples", samples,
      "Number of equal parts of the run after each of which endurance.csv gets a row. Units: none.",
      Integer(10, 1000000));
  declare_checkpoints(prm, checkpoints);
  declare_sph_cell(prm, cell, sph);
}

void CellEndurance::check() const {
  check_sph_cell(cell, sph);
  if (steps != std::floor(steps))
    throw InputError("Steps is " + number_text(steps) + ", but has to be a whole number.");
}

void CellEndurance::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_cell_endurance() { return std::make_unique<CellEndurance>(); }
}  // namespace turgor
