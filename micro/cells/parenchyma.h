// A patch of 2D parenchyma: columns x rows square cells of the inflated period L, glued by middle-lamella
// ties.
//
// Wall springs carry the tension that balances turgor (errata, closed forms): every wall bond has the length
// spacing = L/nodes_per_side and the rest length spacing/lambda_0, where 2 F(lambda_0)/(L z0) = turgor (two
// wall layers per period), F with its yielding where walls yield; the fluid has the density of turgor.
// Corners give a little: turgid_layout.h finds what is free of stress exactly.
//
// Node 0 of a ring is the lower left corner; cell (i, j) is ring j columns + i. In and out: SI units.
#pragma once

#include "micro/cells/cell_layout.h"

namespace turgor {
/// Throws std::invalid_argument with a sentence for parameters outside their range.
CellLayout make_parenchyma(const ParenchymaParameters &parameters, unsigned int columns, unsigned int rows,
                           bool periodic_x, bool periodic_y);

/// lambda_0, the stretch at which the flat walls of square cells hold turgor.
double turgid_wall_stretch(const ParenchymaParameters &parameters);
}  // namespace turgor
