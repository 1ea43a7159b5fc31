// What the surface of deformable cells costs by its area: membrane and active tension.
//
//   E = sum over triangles of  K_A (a - a0)^2/(2 a0) + tau a,   and of the cell  K_t (A - A0)^2/(2 A0)
//                              thesis B.6 (corrected: per triangle, restoring)
//
// so that a triangle pulls at its nodes with -sigma da/dx, sigma = K_A (a - a0)/a0 + K_t (A - A0)/A0 + tau, a
// tension per length (N/m), the same in all directions of its plane. Net force and torque vanish. K_A, K_t:
// N/m, resistance of each triangle and of the whole; tau: N/m, made by the cell itself, whatever its area.
//
// Implicit steps see K_A/a0 g g' and K_t/A0 G G', g = da/dx, G = dA/dx, and where sigma > 0 what tension
// resists out of the plane, sigma a |grad w|^2 (w: displacement along the normal); without the latter free
// nodes would swing from step to step.
#pragma once

#include "micro/engine/term.h"
#include "micro/terms/cell_surfaces.h"

#include <memory>

namespace turgor {
struct AreaStiffness {
  double local = 0.;    ///< K_A, N/m
  double whole = 0.;    ///< K_t, N/m
  double tension = 0.;  ///< tau, N/m
};

class CortexArea final : public Term<3> {
 public:
  CortexArea(std::shared_ptr<CellSurfaces> surfaces, const AreaStiffness &stiffness);

  std::string name() const override { return "cortex_area"; }
  void declare(Particles<3> &) override {}
  void prepare(const Particles<3> &particles, const Box<3> &box, unsigned int threads, bool trial) override;
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;

  /// J, dE/d ln s of a cell, s the scale of its lengths at rest (CellSurfaces::grow): what its growth costs.
  double slope_of_growth(const Particles<3> &particles, std::size_t cell) const;

 private:
  /// N/m, what the whole area adds to every triangle of the cell.
  double of_whole(const Particles<3> &particles, std::size_t group) const;

  std::shared_ptr<CellSurfaces> surfaces;
  AreaStiffness stiffness;
  std::vector<double> energy_of;  ///< J, of cells, where forces were last asked
};
}  // namespace turgor
