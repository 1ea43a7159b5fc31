// What is measured of a population of deformable cells, by the definitions of centre-based ones: each cell
// counts as a sphere of its volume about its centre of mass (terms/outer_cells.h, cells/pressure_profile.h).
//
//   for (const OutputDefinition &column : columns_of_growing_cells()) ...      values: measured(tissue)
#pragma once

#include "micro/scenes/deformable/growing_cells.h"
#include "run/output_list.h"

namespace turgor {
class RunContext;

std::vector<OutputDefinition> columns_of_growing_cells();
/// In the order of the columns.
std::vector<double> measured(const GrowingCells &tissue);

/// profile.csv: pressure and fill by depth, now.
void write_profile(RunContext &context, const GrowingCells &tissue);
Outputs outputs_of_profile();
}  // namespace turgor
