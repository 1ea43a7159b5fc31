// The entries that scenes of Stokes fluids share.
#include "micro/scenes/stokes/stokes_flow.h"
#include "run/input_entries.h"
#include "run/number_text.h"

#include <stdexcept>

namespace turgor {
void StokesFlowParameters::declare(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Fluid");
  prm.add_parameter("Viscosity", viscosity, "Dynamic viscosity of the fluid. Units: Pa s.",
                    Double(1e-9, 1e9));
  prm.add_parameter("Density", density, "Mass density of the fluid at rest. Units: kg/m^3.",
                    Double(1e-3, 1e6));
  prm.add_parameter(
      "Bulk modulus", bulk_modulus,
      "Stiffness of the fluid against compression, 7 K of Eq. 2.22. A hundred times the flow's own "
      "differences of pressure keep its density to 1 %; implicit steps do not get shorter with it. "
      "Units: Pa.",
      Double(1e-9, 1e12));
  prm.add_parameter(
      "Density by", known_by,
      "How a particle's density is known: continuity, from the divergence of the fitted velocity "
      "gradient, with Shifting; summation, from where its neighbours are, as in closed cells. "
      "Units: none.");
  prm.add_parameter(
      "Shifting", shifting,
      "Share, with Density by = continuity, by which particles are moved towards an even packing "
      "in each step, over "
      "the way of the fastest of them and their unevenness. Units: none.",
      Double(0., 10.));
  prm.add_parameter("Ordering pressure", ordering,
                    "Energy density, with Density by = summation, by which an uneven packing is evened out "
                    "while particles flow. "
                    "Units: Pa.",
                    Double(0., 1e12));
  prm.add_parameter("Support", support,
                    "Radius of the kernel (Wendland C2) over the spacing of the particles. Units: none.",
                    Double(2., 4.));
  prm.add_parameter(
      "Viscous form", form,
      "How friction between particles is summed: least_squares, a velocity gradient per particle, "
      "exact for affine flow and objective; morris (Eq. 2.24, 2.31) and monaghan (Eq. 2.25), the "
      "thesis's own pair forms. Units: none.");
  prm.add_parameter("Inertia", inertia,
                    "Whether the fluid has inertia, dv/dt linearly implicit: needs Motion/Method = implicit. "
                    "Units: none.");
  prm.leave_subsection();
  prm.enter_subsection("Motion");
  prm.add_parameter(
      "Method", method,
      "Stepping of the over-damped motion: euler and heun solve for friction alone, and a stiff "
      "fluid shortens their steps; implicit takes the pressure's stiffness in. Units: none.");
  declare_steps(prm);
  prm.leave_subsection();
  declare_packing(prm);
}

void StokesFlowParameters::declare_steps(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Tolerance", tolerance,
                    "Allowed error of a step over the particles' spacing, half the step times the change of "
                    "velocity. Units: none.",
                    Double(1e-9, 1e3));
  prm.add_parameter("Longest step", longest_step, "Largest step in time that is taken. Units: s.",
                    Double(1e-12, 1e12));
  prm.add_parameter("Longest move", longest_move,
                    "No particle moves farther in a step, over the particles' spacing. Units: none.",
                    Double(1e-4, 1.));
  prm.add_parameter("Solver tolerance", solve_tolerance,
                    "Residual of the velocities' linear system over the forces. Units: none.",
                    Double(1e-12, 1e-2));
}

void StokesFlowParameters::declare_packing(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Packing");
  prm.add_parameter(
      "Start", packing,
      "Places of the particles at the start: lattice, a square one; disordered, moved off it at random and "
      "settled by their own pressure. Units: none.");
  prm.add_parameter("Seed", seed, "Number that the disorder is drawn from. Units: none.",
                    Integer(0, 1000000000));
  prm.add_parameter("Settling steps", settling,
                    "Steps without driving in which a disordered packing settles. Units: none.",
                    Integer(0, 1000000));
  prm.leave_subsection();
}

void StokesFlowParameters::check() const {
  if (inertia && method != OverdampedMethod::implicit)
    throw std::invalid_argument("Motion/Method is " + word_of(method) +
                                ", but with Fluid/Inertia = true it has to be implicit.");
  if (method == OverdampedMethod::heun && known_by == BulkDensity::continuity)
    throw std::invalid_argument(
        "Motion/Method is heun, which needs Fluid/Density by = summation: by continuity a density follows "
        "whole "
        "steps. Use euler or implicit, or summation.");
  if (known_by == BulkDensity::continuity && shifting > 1.)
    throw std::invalid_argument("Fluid/Shifting is " + number_text(shifting) +
                                ", but has to be at most 1: more throws particles past their places.");
}
}  // namespace turgor
