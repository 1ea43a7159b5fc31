// The turgid, stress-balanced reference of hydrostatic cells: the fluid mass (kg) per cell for which a periodic patch
// is free of stress at F = I (mean of the virial stress zero, to 1e-10 of turgor or what round-off of the mass
// allows), by secant steps on the mass of one cell, and the node positions (m) there. turgid_reference.h has that of
// cells filled with particles.
#pragma once

#include "micro/cells/parenchyma.h"

#include <vector>

namespace turgor
{
struct TurgidReference
{
  double fluid_mass = 0.;        ///< kg, of one cell
  std::vector<double> positions; ///< m, x and y of every node of the patch
};

/// Throws std::invalid_argument where no mass balances the walls.
TurgidReference turgid_reference(const ParenchymaPatch &patch);
} // namespace turgor
