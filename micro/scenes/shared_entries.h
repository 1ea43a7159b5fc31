// Entries that several particle scenes have, each declared in one place. All of them go into the
// current subsection of prm.
#pragma once

#include "micro/cells/cut_block.h"

#include <string>

namespace turgor {
class InputEntries;
struct BlockLoad;
struct SphParameters;

/// Columns, Rows (cells) and Load (Pa): the clamped block of full_micro and static_lattice.
void declare_block(InputEntries &prm, unsigned int &columns, unsigned int &rows, BlockLoad &load);

/// frozen | free | osmosis | slab, as in cut_block.h
void declare_surfaces(InputEntries &prm, Surfaces &surfaces);

void declare_step_fraction(InputEntries &prm, double &step_fraction);

/// 1: one step for all. check_substeps throws InputError for a fluid that cannot be split off.
void declare_substeps(InputEntries &prm, unsigned int &substeps);
void check_substeps(unsigned int substeps, const SphParameters &sph);

void declare_checkpoints(InputEntries &prm, unsigned int &checkpoints);
}  // namespace turgor
