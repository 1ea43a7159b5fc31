// Definitions of outputs (run/output_list.h) of the scenes of two scales; run_tissue() and what watches it
// write them.
#pragma once

#include "run/output_list.h"

namespace turgor {
/// Of every run of run_tissue(): energies, steps, cost, outlines, fields.
Outputs tissue_run_outputs();

/// Of TipSwing, and of Bruise.
Outputs tip_swing_outputs();
Outputs bruise_outputs();

/// rve_outlines.csv of RveOutlines.
Outputs outlines_outputs();

/// tissue.xdmf of tissue_frame().
Outputs tissue_field_outputs();
}  // namespace turgor
