// Entries of the life of cells that scenes of both kinds of cells have alike: growth with what inhibits it,
// the cycle, the direction in which cells divide. In the current subsection of prm.
#pragma once

#include "micro/laws/cell_cycle.h"
#include "micro/processes/cell_division.h"

#include <string>

namespace turgor {
class InputEntries;

/// Rate, Inhibition, Threshold, Exponent, Quiescence below, Reversible rest, Restriction point, Division at,
/// Mitosis time.
void declare_growth(InputEntries &prm, GrowthLaw &growth, CellCycle &cycle);
/// Direction, Axis; axis: "x, y, z".
void declare_direction(InputEntries &prm, CellDivision &division, std::string &axis);
Vector<3> division_axis(const std::string &axis);
/// Throws InputError where the axis is zero but needed.
void check_direction(const CellDivision &division, const std::string &axis);
/// Throws InputError where mitosis lasts longer than half of the cycle (s).
void check_mitosis(const CellCycle &cycle, double cycle_time);
}  // namespace turgor
