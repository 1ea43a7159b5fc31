// The content of deformable cells, a compressible fluid at rest: one pressure a cell, from its volume,
//
//   p = -K ln v,   v = V/V0,   E = K V0 (v ln v - v + 1),   force on a node p dV/dx          thesis B.11
//                  (corrected)
//
// K: Pa. V0: the volume at rest (m^3). Net force and torque vanish. Implicit steps see K/V G G', G = dV/dx; p
// times V's second derivative is left out.
#pragma once

#include "micro/engine/term.h"
#include "micro/terms/cell_surfaces.h"

#include <memory>

namespace turgor {
class Cytoplasm final : public Term<3> {
 public:
  Cytoplasm(std::shared_ptr<CellSurfaces> surfaces, double bulk_modulus);

  std::string name() const override { return "cytoplasm"; }
  void declare(Particles<3> &) override {}
  /// Throws StepTooLong for a cell without volume.
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;

  /// J, dE/d ln s of a cell, s the scale of its lengths at rest (CellSurfaces::grow): what its growth costs.
  double slope_of_growth(const Particles<3> &particles, std::size_t cell) const;
  double pressure(const Particles<3> &particles, std::size_t cell) const;  ///< Pa, over that outside

 private:
  std::shared_ptr<CellSurfaces> surfaces;
  double bulk_modulus;
};
}  // namespace turgor
