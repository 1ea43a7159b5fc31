// A block of turgid cells (cut_block.h) filled with particles, clamped at the left: the full particle model
// of a piece of tissue.
//
//   TissueBlock block = make_tissue_block(layout, sph, contents, Surfaces::frozen);
//     // any layout that is periodic both ways
//
// In and out: SI units.
#pragma once

#include "micro/cells/cut_block.h"
#include "micro/cells/sph_parenchyma.h"
#include "micro/terms/external_force.h"

namespace turgor {
struct TissueBlock {
  std::unique_ptr<SphPatch> cells;
  BodyForce<2> *body_force = nullptr;
  std::vector<std::uint32_t> probe;  ///< particles of the wall at the middle of the right side
  double width = 0.;                 ///< m
  double density = 0.;               ///< kg/m^3 of the reference, fluid + walls
};

/// contents: what each cell holds at F = I (annealed_cells.h).
TissueBlock make_tissue_block(const CellLayout &periodic, const SphParameters &sph,
                              const std::vector<CellContents> &contents, Surfaces surfaces);
}  // namespace turgor
