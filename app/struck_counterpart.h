// All cells of a tissue that is struck: tissue_bruise against tissue_impact, for `turgor compare`.
//
//   finite elements (struck along x)             all cells (struck along y, downwards)
//   Width, Height                                so many rows, so many columns of cells
//   Lateral sides = free | periodic              Sides = cut | periodic: a block, a strip
//   Structure/Rotation = 90                      0: rows lie across the blow
//   Impact/Speed, Impact/Depth over Width        Speed, End strain
//   Wall/Yielding, Wall/Critical stretch ...     the same without the section
//
// All cells are struck by a plate at constant speed and lie on a plate without friction. What else the input
// asks for is replaced on both sides, and the remark says so. A slab is compared as a strip: nothing depends
// on the place across it.
//
//   if (is_struck(input)) cells = struck_counterpart(input, registry);
#pragma once

#include "app/counterpart.h"

namespace turgor {
bool is_struck(const Input &tissue);

/// Throws InputError with a sentence where all cells cannot have what the input asks for.
Counterpart struck_counterpart(const Input &tissue, const ScenarioRegistry &registry);
}  // namespace turgor
