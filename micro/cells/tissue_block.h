// A rectangular block of turgid cells, clamped at the left: the full particle model of a
// piece of tissue. All cells start as copies of the annealed reference cell.
//
// Surfaces:
//   frozen  the forces that the missing neighbours exert in the reference stay as dead forces, so the
//           block starts in equilibrium and its surface behaves like the interior (what FE^2 assumes)
//   free    nothing outside: turgid surface cells bulge; the block is relaxed before t = 0, at fixed mass
//   osmosis as free, but water flows until every cell has its turgor again
//   slab    periodic in y, frozen at the right side
#pragma once

#include "micro/cells/sph_parenchyma.h"
#include "micro/terms/external_force.h"

namespace turgor
{
enum class Surfaces
{
  frozen,
  free,
  osmosis,
  slab
};

Surfaces surfaces_from(const std::string &name);

struct TissueBlock
{
  std::unique_ptr<SphPatch> cells;
  BodyForce<2> *body_force = nullptr;
  std::vector<std::uint32_t> probe; ///< wall nodes at the middle of the right side
  double width = 0.;                ///< m
  double density = 0.;              ///< kg/m^3 of the reference, fluid + walls
};

TissueBlock make_tissue_block(const ParenchymaParameters &cell, const SphParameters &sph,
                              const CellContents &reference, unsigned int columns, unsigned int rows,
                              Surfaces surfaces);
} // namespace turgor
