// What every scene of deformable cells that touch something says alike: what their cortex is made of, and the
// contact of their surfaces with walls and with each other. Entries are declared once, here.
//
//   TouchingMaterial material;
//   material.declare_motion(prm);
//   prm.enter_subsection("Cell");  material.declare_cortex(prm);  ...   "Contact":
//   material.declare_contact(prm)
#pragma once

#include "micro/laws/surface_adhesion.h"
#include "micro/scenes/deformable/deformable_material.h"
#include "micro/scenes/reference/axial_shell.h"
#include "micro/scenes/stepped_cells.h"

#include <cmath>

namespace turgor {
struct TouchingMaterial : DeformableMaterial {
  // cortex
  double radius = 10e-6;       ///< m, of the sphere without stress
  double modulus = 1000.;      ///< Pa, Young's, of the cortex
  double thickness = 500e-9;   ///< m
  double poisson = 0.5;        ///< of its bending
  double area_modulus = 8e-4;  ///< N/m, K_A
  double tension = 0.;         ///< N/m, tau
  double dashpots = 1e-4;      ///< N s/m, of each edge
  // contact
  double adhesion = 0.;        ///< J/m^2, W
  double range = 0.;           ///< m, h; 0: half of an edge
  double rest = 0.25e-6;       ///< m, d0
  double stiffness = 3e10;     ///< N/m^3, k_r
  double friction = 5e10;      ///< N s/m^3, gamma
  double blend = 0.1e-6;       ///< m, eps; of cells with each other
  double longest_move = 0.05;  ///< of a node in a step, over the radius
  double residual = 1e-3;      ///< of the velocities' equations, over the forces

  /// declare_steps() with the radius, and Residual.
  void declare_motion(InputEntries &prm);
  void declare_cortex(InputEntries &prm);   ///< Radius, Cortex ..., in the current subsection
  void declare_contact(InputEntries &prm);  ///< Adhesion ..., in the current subsection

  void declare_blend(InputEntries &prm);  ///< Blend: of cells with each other

  double spring() const { return 0.5 * std::sqrt(3.) * modulus * thickness; }  ///< N/m, k of an edge
  double hinge() const {                                                       ///< N m, k_b
    return 2. / std::sqrt(3.) * modulus * std::pow(thickness, 3) / (12. * (1. - poisson * poisson));
  }
  double edge() const;  ///< m, mean length
  CellSteps steps() const { return {radius, tolerance, longest_step, longest_move, residual}; }
  SurfaceAdhesion law() const;
  /// Edges over the length sqrt(D/W) in which adhesion bends the cortex at the rim of a contact; above 1.5
  /// the mesh does not resolve how contacts peel.
  double mesh_ratio() const;
  /// Throws InputError with a sentence about an entry.
  void check_contact() const;
  AxialShellParameters shell() const;  ///< the same cell as a shell of revolution

 private:
  void check_reach() const;
};

class RunContext;
/// Result mesh_ratio, with a note where the mesh does not resolve the rim of an adhesive contact.
void judge_mesh(RunContext &context, const TouchingMaterial &material);
}  // namespace turgor
