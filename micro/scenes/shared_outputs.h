// Definitions of outputs (run/output_list.h) that several scenes share.
#pragma once

#include "run/output_list.h"

namespace turgor {
/// wall.xdmf and fluid.xdmf of RoundCellFields.
Outputs round_cell_field_outputs();

/// cell_displacement.csv: mean displacement of every cell of a block.
Outputs cell_displacement_outputs();

/// tip_displacement_x, _y; probe.csv, if the scene writes it.
Outputs tip_outputs(bool with_table);

/// density, body_force, width of a block that carries its own weight.
Outputs block_outputs();

/// What the energy of a particle system is called in the tables: potential, kinetic.
std::vector<OutputDefinition> energy_columns();
}  // namespace turgor
