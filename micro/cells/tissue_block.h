// A block of turgid cells (cut_block.h) filled with particles, clamped at the left: the full particle model
// of a piece of tissue.
//
//   TissueBlock block = make_tissue_block(layout, sph, contents, Surfaces::frozen, load);
//     // any layout that is periodic both ways
//
// In and out: SI units.
#pragma once

#include "micro/cells/block_load.h"
#include "micro/cells/cut_block.h"
#include "micro/cells/sph_parenchyma.h"
#include "micro/terms/external_force.h"

namespace turgor {
struct TissueBlock {
  std::unique_ptr<SphPatch> cells;
  BodyForce<2> *body_force = nullptr;
  DeadForce<2> *traction = nullptr;  ///< on the right side; nullptr: none
  Vector<2> acceleration{0., 0.};    ///< m/s^2, of the body force once it is put on
  std::vector<std::uint32_t> probe;  ///< particles of the wall at the middle of the right side
  double width = 0.;                 ///< m
  double density = 0.;               ///< kg/m^3 of the reference, fluid + walls

  /// From now on it carries what it was made for; before, nothing.
  void put_on_load();
};

/// contents: what each cell holds at F = I (annealed_cells.h). The load is not on yet.
TissueBlock make_tissue_block(const CellLayout &periodic, const SphParameters &sph,
                              const std::vector<CellContents> &contents, Surfaces surfaces,
                              const BlockLoad &load = {});
}  // namespace turgor
