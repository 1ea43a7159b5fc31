#include "rve/rve_parameters.h"

#include "micro/cells/sph_cell_entries.h"
#include "micro/cells/turgid_limit.h"
#include "run/input_entries.h"

#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
// Newton on one pressure per cell reaches round-off, about 1e-13. Damped particles come to about 2e-3 at
// moderate deformations; below 1e-3 a call only spends its steps.
constexpr double hydrostatic_tolerance = 1e-9, sph_tolerance = 1e-3;
}  // namespace

double RveParameters::equilibrium_tolerance() const {
  if (tolerance == 0.) return fluid == RveFluid::sph ? sph_tolerance : hydrostatic_tolerance;
  if (tolerance < least_tolerance) {
    std::ostringstream text;
    text << "RVE/Tolerance is " << tolerance << "; allowed are 0 (what suits RVE/Fluid) and "
         << least_tolerance << " to 0.1.";
    throw std::invalid_argument(text.str());
  }
  return tolerance;
}

ParenchymaParameters RveParameters::yielding_cell() const {
  ParenchymaParameters c = cell;
  if (yielding != Yielding::none) c.wall_yield = yield;
  return c;
}

WallLimits RveParameters::wall_limits() const {
  WallLimits limits = walls;
  limits.plastic = yielding == Yielding::plastic;
  return limits;
}

void RveParameters::declare_walls(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Wall");
  prm.add_parameter("Yielding", yielding,
                    "Whether walls soften when they are stretched (thesis Eq. 3.8): none; reversible, along "
                    "the same curve back; "
                    "plastic, elastic on the way back, so that a stretch stays. Units: none.");
  declare_yield(prm, yield);
  prm.rename("Yield sharpness A", "Yield sharpness");
  prm.rename("Yield drop B", "Yield drop");
  prm.add_parameter("Critical stretch", walls.critical_stretch,
                    "Length over length at rest (before inflation and flow) at which a bond of the wall "
                    "breaks, for good; its cell "
                    "has failed and loses its fluid. 0: walls do not break. Units: 1.",
                    Double(0., 100.));
  prm.add_parameter(
      "Leak time", walls.leak_time,
      "Time in which the pressure of a failed cell falls to 1/e at constant volume. 0: at once. Units: s.",
      Double(0., 1e6));
  prm.add_parameter("Residue", walls.residue,
                    "Share of its fluid that cannot leave a failed cell and resists when the cell is pressed "
                    "below that volume. "
                    "Units: 1.",
                    Double(0., 0.99));
  prm.add_parameter(
      "Broken bond stiffness", walls.broken_share,
      "Share of its stiffness that a broken bond keeps, so that loose ends of wall stay in place. Units: 1.",
      Double(1e-8, 0.1));
  prm.leave_subsection();
}

namespace {
void declare_air(InputEntries &prm, RveAir &air, double &pressure) {
  prm.add_parameter("Air", air,
                    "Air in the spaces that Gap opens: connected with the air outside, so that it leaves "
                    "freely and has no pressure; or shut in, cell walls between, and then isothermal (small "
                    "spaces between wet walls, slower than some microseconds) or adiabatic (exponent 1.4): "
                    "such air is compressed "
                    "with the tissue and makes it stiffer. "
                    "Units: none.");
  prm.add_parameter(
      "Air pressure", pressure,
      "Absolute pressure of air that is shut in, in the undeformed tissue, which it then leaves "
      "free of stress as the air outside does. Units: Pa.",
      Patterns::Double(1e3, 1e7));
}
}  // namespace

void RveParameters::add_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("RVE");
  prm.add_parameter(
      "Rule", rule,
      "How the cells follow F (thesis 3.4.2): cauchy_born moves them affinely, elastic_equilibrium "
      "relaxes them, constrained_runs lets them move for a burst and rescales. Units: none.");
  prm.add_parameter("Fluid", fluid,
                    "Cell fluid: hydrostatic (one pressure per cell plus the viscous stress of F_dot) or sph "
                    "(particles). Units: none.");
  prm.add_parameter("Columns", columns,
                    "Number of cells of the RVE along x (before Structure/Rotation). Units: 1.",
                    Integer(1, 100));
  prm.add_parameter(
      "Boundary", boundary,
      "What holds the boundary of the RVE: periodic, its images; linear_displacement, walls at "
      "the boundary follow F (stiffest); uniform_traction, they are pulled by one stress "
      "(softest). The last two are windows cut along walls, for studies of size; they need Fluid "
      "= hydrostatic and Rule = elastic_equilibrium. Units: none.");
  prm.add_parameter("Rows", rows, "Number of cells of the RVE along y (before Structure/Rotation). Units: 1.",
                    Integer(1, 100));
  prm.add_parameter(
      "Tolerance", tolerance,
      "Largest unbalanced force on a wall node or particle at equilibrium, over turgor * node spacing * "
      "depth: 1e-13 to 0.1, or 0 for what suits the fluid, which is 1e-9 with Fluid = hydrostatic and 1e-3 "
      "with Fluid = sph. Particles stop at it and count as balanced up to 50 times it. Units: 1.",
      Double(0., 1e-1));
  prm.add_parameter("Most iterations", max_iterations,
                    "Newton iterations after which one search for equilibrium gives up. Units: 1.",
                    Integer(1, 100000));
  prm.rename("Max iterations", "Most iterations");
  prm.add_parameter("Window tau_0", window,
                    "Time in the middle of a constrained-runs burst over which the virial stress is averaged "
                    "(Eq. 3.17), at most "
                    "the burst; 0 takes the middle alone. Units: s.",
                    Double(0., 1.));
  prm.add_parameter(
      "Burst length", burst,
      "Time a constrained-runs burst lasts, two micro steps at least. From call to call the tissue goes on "
      "by a macro step, "
      "the cells by Bursts * Burst length. Where that is less, what moves inside the cells (viscous "
      "relaxation, inertia) "
      "is slowed by the ratio: good for slow loading, not for dynamics, which bursts follow that last a "
      "macro step. Such "
      "bursts cost an RVE what the same cells cost in a full particle run, so with more cells in the RVEs "
      "than in the "
      "piece the full run (scene full_micro) is cheaper. A run tells where it stands. Units: s.",
      Double(0., 1.));
  prm.add_parameter("Bursts", bursts, "Number of bursts in one call of constrained_runs. Units: 1.",
                    Integer(1, 1000));
  prm.add_parameter("Step fraction", step_fraction,
                    "Micro time step over the stable limit that the terms state; for Fluid = sph. Units: 1.",
                    Double(0.01, 1.));
  prm.add_parameter("Relax steps", relax_steps,
                    "Damped steps that one call of elastic_equilibrium may take with Fluid = sph; a change "
                    "of F that stretches by "
                    "more than 16 % may take up to twice as many for every 16 %, and half and quarter steps "
                    "where the cells "
                    "need them. Units: steps.",
                    Integer(0, 10000000));
  prm.leave_subsection();
  prm.enter_subsection("Structure");
  structure.add_parameters(prm);
  declare_air(prm, air, air_pressure);
  prm.leave_subsection();
  prm.enter_subsection("SPH");
  sph.add_parameters(prm);
  prm.leave_subsection();
  declare_walls(prm);
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
}

AirGasLaw RveParameters::air_gas() const {
  if (air == RveAir::connected) return {};
  return {air_pressure, air == RveAir::adiabatic ? 1.4 : 1.};
}

void RveParameters::check() const {
  equilibrium_tolerance();
  structure.check();
  structure.check_file(cell.wall_thickness);
  require_walls_that_hold(structure, yielding_cell());
  make_parenchyma(yielding_cell(), columns, rows, true, true);
  if (structure.gap > 0. && fluid != RveFluid::hydrostatic) {
    std::ostringstream text;
    text << "Structure/Gap is " << structure.gap
         << " m, but the walls of an RVE of particles (RVE/Fluid = " << word_of(fluid)
         << ") do not touch across air spaces: use 0, or RVE/Fluid = hydrostatic.";
    throw std::invalid_argument(text.str());
  }
  if (air != RveAir::connected && !(structure.gap > 0.))
    throw std::invalid_argument("Structure/Air is " + word_of(air) +
                                ", but with Structure/Gap = 0 there is none: use connected, or a Gap.");
  if (fluid == RveFluid::hydrostatic && rule == RveRule::constrained_runs)
    throw std::invalid_argument(
        "RVE/Rule is " + word_of(rule) +
        ", which needs a fluid that flows. With RVE/Fluid = hydrostatic use cauchy_born or "
        "elastic_equilibrium.");
  if (boundary != RveBoundary::periodic &&
      (fluid != RveFluid::hydrostatic || rule != RveRule::elastic_equilibrium))
    throw std::invalid_argument("RVE/Boundary is " + word_of(boundary) +
                                ", which needs 'RVE/Fluid = hydrostatic' and 'RVE/Rule = "
                                "elastic_equilibrium'.");
  if (boundary != RveBoundary::periodic && structure.gap > 0.) {
    std::ostringstream text;
    text << "Structure/Gap is " << structure.gap << " m, but a window (RVE/Boundary = " << word_of(boundary)
         << ") would be cut through air spaces: use 0, or RVE/Boundary = periodic.";
    throw std::invalid_argument(text.str());
  }
  const WallLimits limits = wall_limits();
  limits.check(yield);
  if (limits.failure() || yielding != Yielding::none) {
    if (fluid != RveFluid::hydrostatic)
      throw std::invalid_argument("Wall/Yielding = " + word_of(yielding) +
                                  " and Wall/Critical stretch need 'RVE/Fluid = hydrostatic' "
                                  "(it is " +
                                  word_of(fluid) + ").");
    if (limits.history() && rule != RveRule::elastic_equilibrium)
      throw std::invalid_argument("RVE/Rule is " + word_of(rule) +
                                  ", but walls that flow or break need elastic_equilibrium.");
    const double lambda_0 = turgid_wall_stretch(yielding_cell());
    if (limits.failure() && limits.critical_stretch <= lambda_0) {
      std::ostringstream text;
      text << "Wall/Critical stretch is " << limits.critical_stretch
           << ", but turgor alone stretches the walls to " << lambda_0
           << "; allowed is more than that, or 0 for walls that do not break.";
      throw std::invalid_argument(text.str());
    }
  }
  if (fluid == RveFluid::sph)
    check_sph_cell(cell, sph);
  else
    sph.check();
}
}  // namespace turgor
