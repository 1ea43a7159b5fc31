// One round cell as the user asks for it: the entries of the subsection Cell of the scenes with a round cell.
// lambda_0 is the stretch at which a round wall of radius R holds turgor:
//
//   2D   F(lambda_0) = turgor R z0                 (RingWall, Eq. 3.4)
//   3D   G t0 (1 - lambda_0^-6) = turgor R/2       (NetWall, Eq. 3.6; there is none if turgor R/2 >= G t0)
//
// SI units.
#pragma once

#include "micro/cells/fluid_parameters.h"
#include "micro/cells/wall_parameters.h"
#include "run/choice.h"

#include <string>

namespace turgor {
class InputEntries;
/// What fills a cell.
enum class CellFilling {
  sph,       ///< particles
  thesis,    ///< particles by the thesis's scheme
  pressure,  ///< one pressure for the whole cell
  none       ///< an empty shell
};
constexpr const char *words_of(CellFilling) { return "sph|thesis|pressure|none"; }

struct RoundCellParameters : WallParameters, FluidParameters {
  RoundCellParameters() { wall_thickness = 126e-9; }

  double radius = 30e-6;          ///< m, R of the turgid cell
  double depth = 50e-6;           ///< m, slab depth (2D)
  unsigned int ring_nodes = 100;  ///< wall nodes (2D)
  unsigned int frequency = 14;    ///< of the geodesic sphere: 10 nu^2 + 2 wall nodes (3D)
  CellFilling fluid = CellFilling::sph;
  unsigned int fluid_particles = 5000;
  bool fourth_order = false;  ///< kernel; else Wendland's
  double support_ratio = 2.6, skin_ratio = 0.2, ordering = 0.01;
  unsigned int seed = 1;
  unsigned int settle_steps = 0, anneal_steps = 8000, rest_steps = 10000;  ///< bring_to_turgor.h
  double rest_residual = 0.1;  ///< largest unbalanced force over turgor times the wall of a node

  /// Declares all entries in the current subsection of prm.
  void add_parameters(InputEntries &prm);
  /// Throws std::invalid_argument: entry, value, allowed range.
  void check(int dim) const;
  bool has_particles() const { return fluid == CellFilling::sph || fluid == CellFilling::thesis; }
  /// lambda_0.
  double turgid_stretch(int dim) const;
};
}  // namespace turgor
