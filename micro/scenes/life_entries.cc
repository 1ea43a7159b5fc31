#include "micro/scenes/life_entries.h"

#include "run/input_entries.h"
#include "run/run_context.h"
#include "run/number_text.h"
#include "run/user_text.h"

namespace turgor {
void declare_growth(InputEntries &prm, GrowthLaw &growth, CellCycle &cycle) {
  using namespace Patterns;
  prm.add_parameter("Rate", growth.exponential,
                    "How the volume of an uncompressed cell grows over its cycle: constant, by the same "
                    "volume every second, or exponential (C.5). Units: none.",
                    Selection("constant|exponential"));
  prm.add_parameter("Inhibition", growth.inhibition,
                    "How compression slows growth down, by the volumetric strain log(V_ref/V): none, hill "
                    "(5.2) or linear (5.4.2). Units: none.");
  prm.add_parameter("Threshold", growth.threshold,
                    "Volumetric strain log(V_ref/V), positive when compressed, at which Inhibition leaves "
                    "half of the free growth. Units: none.",
                    Double(1e-6, 1e6));
  prm.add_parameter("Exponent", growth.exponent,
                    "Exponent n of Inhibition = hill: the larger, the sharper the threshold. Units: none.",
                    Double(0.1, 1e4));
  prm.add_parameter("Quiescence below", cycle.quiescence_below,
                    "alpha_qui: share of the free growth below which a cell before its restriction point "
                    "rests. Units: none.",
                    Double(0., 1.));
  prm.add_parameter("Reversible rest", cycle.reversible,
                    "Whether resting cells go on with their cycle when they are less compressed; else they "
                    "rest for good. Units: true or false.",
                    Bool());
  prm.add_parameter("Restriction point", cycle.restriction,
                    "Phase of the cycle (0 newborn, 1 divides) from which on a cell does not go to rest any "
                    "more. Units: none.",
                    Double(0., 1.));
  prm.add_parameter(
      "Division at", cycle.timer,
      "When a cell divides: at twice its volume at birth (size) or after its cycle time (time). Units: none.",
      Selection("size|time"));
  prm.add_parameter("Mitosis time", cycle.mitosis, "Time after birth in which cells do not grow. Units: s.",
                    Double(0., 1e12));
}

void declare_direction(InputEntries &prm, CellDivision &division, std::string &axis) {
  using namespace Patterns;
  prm.add_parameter("Direction", division.direction,
                    "Line on which daughters lie: random, random_in_plane (z = 0), least_stress (where the "
                    "mother is pressed least) or given (Axis). Units: none.");
  prm.add_parameter(
      "Axis", axis,
      "Line on which daughters lie with Direction = given, of any length: x, y, z. Units: none.",
      List(Double(-1e6, 1e6), 3, 3, ","));
}

Vector<3> division_axis(const std::string &axis) {
  const std::vector<double> values = read_numbers(axis, 3, "Division/Axis", "x, y, z");
  return {values[0], values[1], values[2]};
}

void check_direction(const CellDivision &division, const std::string &axis) {
  if (division.direction == DivisionDirection::given && !(division_axis(axis).norm() > 0.))
    throw InputError("Division/Axis is " + axis + ", but Direction = given needs one that is not zero.");
}

void check_mitosis(const CellCycle &cycle, const double cycle_time) {
  if (cycle.mitosis > 0.5 * cycle_time)
    throw InputError("Growth/Mitosis time is " + number_text(cycle.mitosis) +
                     " s, but has to be at most half of Cell/Cycle time (" + number_text(cycle_time) +
                     " s).");
}
}  // namespace turgor
