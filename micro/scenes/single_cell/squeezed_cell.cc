#include "micro/scenes/single_cell/squeezed_run.h"

#include "micro/scenes/shared_entries.h"
#include "run/entry_marks.h"
#include "run/input_entries.h"
#include "run/number_text.h"

#include <cmath>

namespace turgor {
void SqueezedCell::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Dimension", dimension, "Dimension of the cell: 2 a round slab, 3 a sphere. Units: none.",
                    Integer(2, 3));
  prm.add_parameter("Speed", speed, "Speed at which the plates approach each other. Units: m/s.",
                    Double(1e-4, 1000.));
  prm.add_parameter("Both plates move", both_move,
                    "Whether both plates move, each at half the Speed; else the upper one alone moves. "
                    "Units: true or false.",
                    Bool());
  prm.add_parameter("Damping", damping,
                    "Rate at which all velocities decay, for quasi-static loading; 0: none. Units: 1/s.",
                    Double(0., 1e12));
  prm.add_parameter(
      "Deformation", deformation,
      "Approach of the plates at the end of the run, over the height 2 R of the turgid cell. Units: none.",
      Double(0.001, 0.9));
  prm.add_parameter("Plate mass", plate_mass,
                    "Mass of the upper plate, which then starts at Speed and moves by its own inertia, Plate "
                    "force and the cell; 0: driven at Speed. "
                    "Units: kg.",
                    Double(0., 1.));
  prm.add_parameter("Plate force", plate_force,
                    "Plate mass > 0: constant force that presses the upper plate down. Units: N.",
                    Double(0., 1e6));
  prm.add_parameter("End time", end_time,
                    "Plate mass > 0: length of the run, in place of Deformation. Units: s.", Double(0., 1e3));
  prm.add_parameter("Plate stiffness", plate_stiffness,
                    "Force with which a plate pushes a wall node back, over how far it is behind the plate; "
                    "0: ten times Cell/Wall stiffness. Units: N/m.",
                    Double(0., 1e9));
  prm.add_parameter(
      "Critical stretch", critical_stretch,
      "lambda_c at which a bond of the wall breaks, above 1; 0: walls do not fail. Units: none.",
      Double(0., 100.));
  prm.add_parameter("Samples", samples,
                    "Number of equal parts of the run after each of which force.csv gets a row. Units: none.",
                    Integer(2, 1000000));
  prm.add_parameter("Frames", frames,
                    free_to_change("Number of equal parts of the run after each of which wall and fluid are "
                                   "written for ParaView and pictures; 0: never. Units: none."),
                    Integer(0, 100000));
  declare_step_fraction(prm, step_fraction);
  declare_checkpoints(prm, checkpoints);
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
}

void SqueezedCell::check() const {
  cell.check(int(dimension));
  if (plate_mass > 0. && (both_move || !(end_time > 0.)))
    throw InputError(
        "Plate mass is above 0: such a run needs End time > 0 (s), and only the upper plate moves.");
  if (!(plate_mass > 0.) && (plate_force > 0. || end_time > 0.))
    throw InputError(
        "Plate force and End time are for a plate that has mass; a driven one (Plate mass = 0) needs 0 for "
        "both.");
  if (critical_stretch > 0. && cell.has_particles() && cell.fourth_order)
    throw InputError(
        "Cell/Kernel is fourth_order, but a wall that can break (Critical stretch above 0) needs wendland: "
        "what the other gives beside a hole is not known.");
  if (critical_stretch != 0. && !(critical_stretch > cell.turgid_stretch(int(dimension))))
    throw InputError("Critical stretch is " + number_text(critical_stretch) +
                     ", but has to be 0 or larger than the stretch of the turgid wall, " +
                     number_text(cell.turgid_stretch(int(dimension))) + ".");
}

void SqueezedCell::result_at(RunContext &context, const Rows &rows, const std::string &name,
                             double Row::*quantity, const std::string &unit) {
  for (const int percent : {5, 10, 15, 20, 25, 30, 40, 50})
    if (const double value = squeezed::at(rows, quantity, 0.01 * percent - 1e-9); std::isfinite(value))
      context.result(name + "_at_" + (percent < 10 ? "0" : "") + number_text(percent), value, unit);
}

void SqueezedCell::run(RunContext &context) {
  if (dimension == 2)
    Run<2>(*this, context).go();
  else
    Run<3>(*this, context).go();
}
}  // namespace turgor
