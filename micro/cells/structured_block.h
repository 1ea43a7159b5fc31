// A block with upright sides of tissue of any structure (tissue_structure.h), for the scenes that clamp it at
// its left side (cut_block.h): the very tissue that an RVE of the same entries stands for.
//
//   check_block(structure, cell, rows);
//   const CellLayout block = turgid_block(structure, cell, 16, 16);      // periodic both ways, at right
//   angles
//
// Of hexagons and bricks every other row sticks out at the right by half a cell, and stands back at the
// clamp.
#pragma once

#include "micro/cells/tissue_structure.h"

namespace turgor {
/// Throws std::invalid_argument with a sentence: a tissue that is turned, rows that come in twos, turgor that
/// walls do not hold.
void check_block(const TissueStructure &structure, const ParenchymaParameters &cell, unsigned int rows);

/// At turgor. Where all cells are alike one pair of rows comes to turgor and is repeated. Throws
/// std::invalid_argument.
CellLayout turgid_block(const TissueStructure &structure, const ParenchymaParameters &cell,
                        unsigned int columns, unsigned int rows);

/// columns x rows copies side by side of tissue that is periodic both ways, one row of copies after the
/// other, in it cell after cell: cell c of copy (i, j) comes at (j cells + c) columns + i.
CellLayout repeated(const CellLayout &layout, unsigned int columns, unsigned int rows);

/// Whether all cells are one, moved: rings, lengths and masses, to 1e-6 of a spacing. What one holds then
/// serves all.
bool all_alike(const CellLayout &layout);

/// Where a cell stands in the block, for tables: column and row where cells stand in rows; else its centroid
/// over the mean width of a cell.
Vector<2> place_in_block(const TissueStructure &structure, const CellLayout &layout, unsigned int columns,
                         std::size_t cell);
}  // namespace turgor
