// The user's entries for an RVE: subsections "RVE" (rule, fluid, size, accuracy), "Structure"
// (micro/cells/tissue_structure.h), "Wall" (yielding and failure) and "Cell" (micro/cells/parenchyma.h).
// Declared once, used by every scene that has RVEs.
#pragma once

#include "micro/cells/air_gas.h"
#include "micro/cells/sph_parenchyma.h"
#include "micro/cells/tissue_structure.h"
#include "micro/cells/wall_history.h"
#include "micro/laws/yielding.h"
#include "run/choice.h"
#include "rve/rve_boundary.h"

#include <string>

namespace turgor {
class InputEntries;
/// How the cells follow F (thesis 3.4.2).
enum class RveRule {
  cauchy_born,          ///< cells move affinely
  elastic_equilibrium,  ///< they relax
  constrained_runs      ///< they move for a burst
};
constexpr const char *words_of(RveRule) { return "cauchy_born|elastic_equilibrium|constrained_runs"; }

enum class RveFluid {
  hydrostatic,  ///< one pressure per cell
  sph           ///< particles
};
constexpr const char *words_of(RveFluid) { return "hydrostatic|sph"; }

/// Of the air between the cells (air_gas.h).
enum class RveAir {
  connected,   ///< with the air outside: it leaves freely
  isothermal,  ///< shut in
  adiabatic    ///< shut in, and keeps its heat
};
constexpr const char *words_of(RveAir) { return "connected|isothermal|adiabatic"; }

struct RveParameters {
  RveRule rule = RveRule::elastic_equilibrium;
  RveFluid fluid = RveFluid::hydrostatic;
  RveBoundary boundary = RveBoundary::periodic;
  unsigned int columns = 1, rows = 1;  ///< cells in the RVE
  TissueStructure structure;           ///< how they lie
  RveAir air = RveAir::connected;      ///< between them
  double air_pressure = 101325.;       ///< Pa, of air that is shut in, at F = I
  double tolerance = 0.;               ///< as entered, 0: what suits the fluid; see equilibrium_tolerance()
  unsigned int max_iterations = 300;   ///< Newton iterations of one call
  double window = 1e-7;                ///< s, tau_0 of the averaged virial stress (Eq. 3.17)
  double burst = 2e-7;                 ///< s, length of a constrained-runs burst
  unsigned int bursts = 1;             ///< bursts per call
  double step_fraction = 0.9;          ///< micro step over its stable limit
  unsigned int relax_steps = 2000;     ///< elastic_equilibrium with particles: damped steps of one call
  Yielding yielding = Yielding::none;
  WallYield yield = {15., 0.9};  ///< A, B of Eq. 3.8, where walls yield
  WallLimits walls;              ///< plastic is set by yielding
  SphParameters sph;             ///< used with fluid = sph only
  ParenchymaParameters cell;

  static constexpr double least_tolerance =
      1e-13;  ///< that an entry may ask for; Newton on one pressure per cell reaches it

  /// Largest unbalanced force / (turgor * spacing * depth). Throws std::invalid_argument for an entry that no
  /// search can reach.
  double equilibrium_tolerance() const;

  /// The cell with its yielding, and the limits of its walls, as entered.
  ParenchymaParameters yielding_cell() const;
  WallLimits wall_limits() const;
  AirGasLaw air_gas() const;

  /// Declares subsections "RVE", "Structure", "SPH", "Wall" and "Cell" in the current subsection of prm.
  void add_parameters(InputEntries &prm);
  /// Throws std::invalid_argument, entry and allowed range in one sentence.
  void check() const;

 private:
  void declare_walls(InputEntries &prm);
};
}  // namespace turgor
