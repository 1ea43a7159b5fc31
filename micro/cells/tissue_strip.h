// A strip of tissue that is periodic along x and has an end above and below, for aggregates between plates:
// cut out of the very layout that is the reference F = I of an RVE (tissue_structure.h), with the same walls
// at the same lengths without stress, the same ties, the same period along x at turgor. What differs from the
// RVE is the end rows alone: ties that would leave across the second period are not there, and air spaces
// there are open. Walls around air touch as those of the RVE do (air_contact.h, law_of).
//
//   const BrickLayout strip = lay_strip(structure, cell, 3, 8);      // 3 cells around, 8 rows
//
// StripEnds::all: a block of the same cells, with sides as well. The first period lies along x. In and out:
// m.
#pragma once

#include "micro/cells/brick_layout.h"
#include "micro/cells/tissue_structure.h"

namespace turgor {
/// Where the tissue ends.
enum class StripEnds { above_and_below, all };

/// cell: with the walls' yielding. Throws std::invalid_argument with a sentence where such a strip cannot be:
/// cells that do not stand in rows, a tissue that is turned, a block with an odd number of rows that are
/// moved.
BrickLayout lay_strip(const TissueStructure &structure, const ParenchymaParameters &cell,
                      unsigned int columns, unsigned int rows, StripEnds ends = StripEnds::above_and_below);

/// The same sentences without finding the state at turgor.
void check_strip(const TissueStructure &structure, const ParenchymaParameters &cell, unsigned int rows,
                 StripEnds ends);
}  // namespace turgor
