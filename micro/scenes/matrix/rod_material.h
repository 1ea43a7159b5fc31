// What a cell of the rod model is made of (thesis 2.3.3), and how it is stepped: entries of all scenes with
// rods.
//
//   RodMaterial cell;   cell.declare_motion(prm);   prm.enter_subsection("Cell"); cell.declare(prm); ...
//   RodContactParameters p = cell.contacts();
#pragma once

#include "micro/scenes/stepped_cells.h"
#include "micro/terms/rod_contacts.h"
#include "micro/terms/rod_obstacles.h"

namespace turgor {
class InputEntries;

struct RodMaterial {
  double radius = 6e-6, modulus = 500., poisson = 0.5;  ///< m, Pa
  double nucleus_radius = 3e-6, nucleus_ratio = 10.;    ///< m; modulus over the cell's
  double shape_stiffness = 0., relaxation = 30.;        ///< N/m, k_cell, 0: that of an elastic ball; s
  double medium = 0.01, friction = 1e9;                 ///< N s/m, N s/m^3
  double tolerance = 0.02, longest_step = 1., residual = 1e-5, longest_move = 0.05;

  void declare(InputEntries &prm);
  void declare_motion(InputEntries &prm);
  /// Throws InputError where the nucleus fills the cell.
  void check() const;

  /// N/m. Unless it is given: what an incompressible elastic ball of this modulus, stretched as much along
  /// its axis as the rod is (L/(4 R_0), to the first order), resists: 17/16 k L^2/2 = E/2 (L/(4 R_0))^2 V.
  double stiffness() const;
  RodShape shape() const { return {radius, stiffness()}; }
  double inner_friction() const { return relaxation * stiffness(); }           ///< N s/m, mu
  double plane_modulus() const { return modulus / (1. - poisson * poisson); }  ///< Pa
  CellSteps steps() const { return {radius, tolerance, longest_step, longest_move, residual}; }
  RodContactParameters contacts(const ContactLaw &law, std::uint32_t nodes, double node_radius) const;
  RodObstacleParameters obstacles() const;
};
}  // namespace turgor
