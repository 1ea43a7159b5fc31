// Bending of the cortex of deformable cells: a hinge at every edge,
//
//   E = k_b (1 - cos(theta - theta_0)),   moment k_b sin(theta - theta_0)          thesis B.7 (corrected:
//     theta with its sign, geometry/triangle_hinge.h)
//
// k_b = (2/sqrt 3) D (errata B.9), D = E h^3/(12 (1 - nu^2)) of the cortex, N m. theta_0 is the angle at rest
// (rad). Net force and torque vanish. Implicit steps see k_b cos(theta - theta_0) g g', g = d theta/dx, where
// it is positive; theta's second derivative is left out.
#pragma once

#include "micro/engine/term.h"
#include "micro/terms/cell_surfaces.h"

#include <memory>

namespace turgor {
class CortexHinges final : public Term<3> {
 public:
  /// stiffness: k_b, N m.
  CortexHinges(std::shared_ptr<CellSurfaces> surfaces, double stiffness);

  std::string name() const override { return "cortex_hinges"; }
  void declare(Particles<3> &) override {}
  void prepare(const Particles<3> &particles, const Box<3> &box, unsigned int threads, bool trial) override;
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;

 private:
  struct Direction {
    double sine, cosine;
  };

  std::shared_ptr<CellSurfaces> surfaces;
  double stiffness;
  std::vector<double> rest_angle;  ///< rad, of edges, of which `at_rest` was made
  std::vector<Direction> at_rest;
  // where forces were last asked
  std::vector<double> softness;   ///< of edges, 1 - cos(theta - theta_0)
  std::vector<double> energy_of;  ///< J, of cells
};
}  // namespace turgor
