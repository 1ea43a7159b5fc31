// Entries that several particle scenes have, each declared in one place. All of them go into the
// current subsection of prm.
#pragma once

#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace turgor
{
struct SphParameters;

/// Columns, Rows (cells) and Load (Pa): the clamped block of full_micro and static_lattice.
void declare_block(dealii::ParameterHandler &prm, unsigned int &columns, unsigned int &rows, double &load);

/// frozen | free | osmosis | slab, as in tissue_block.h
void declare_surfaces(dealii::ParameterHandler &prm, std::string &surfaces);

void declare_step_fraction(dealii::ParameterHandler &prm, double &step_fraction);

/// 1: one step for all. check_substeps throws InputError for a fluid that cannot be split off.
void declare_substeps(dealii::ParameterHandler &prm, unsigned int &substeps);
void check_substeps(unsigned int substeps, const SphParameters &sph);

void declare_checkpoints(dealii::ParameterHandler &prm, unsigned int &checkpoints);
} // namespace turgor
