#include "micro/scenes/stokes/solid_entries.h"

#include "run/input_entries.h"
#include "run/number_text.h"

#include <stdexcept>

namespace turgor {
void SolidParameters::declare(InputEntries &prm, const bool with_friction) {
  using namespace Patterns;
  prm.enter_subsection("Solid");
  prm.add_parameter("Young's modulus", young, "Young's modulus of the intact solid. Units: Pa.",
                    Double(1e-6, 1e12));
  prm.add_parameter("Poisson's ratio", poisson,
                    "Poisson's ratio of the intact solid; the scene is in plane strain. Units: none.",
                    Double(0., 0.499));
  if (with_friction)
    prm.add_parameter("Viscosity", viscosity,
                      "Dynamic viscosity of the friction that acts beside the elastic stress. Units: Pa s.",
                      Double(1e-9, 1e9));
  prm.add_parameter("Density", density, "Mass density of the solid at rest. Units: kg/m^3.",
                    Double(1e-3, 1e6));
  prm.add_parameter("Support", steps.support,
                    "Radius of the kernel (Wendland C2) over the spacing of the particles. Units: none.",
                    Double(2., 4.));
  prm.leave_subsection();
}

void SolidParameters::declare_motion(InputEntries &prm) {
  prm.enter_subsection("Motion");
  steps.declare_steps(prm);
  prm.leave_subsection();
  steps.declare_packing(prm);
}

void SolidParameters::check() const {
  steps.check();
  const double longest = viscosity / elastic().shear;
  if (steps.longest_step > longest)
    throw std::invalid_argument(
        "Motion/Longest step is " + number_text(steps.longest_step) + " s, but has to be at most " +
        number_text(longest) +
        " s, the viscosity over the shear modulus: what holds particles in the pattern they were laid in is "
        "explicit.");
}

StokesFlowParameters SolidParameters::flow() const {
  StokesFlowParameters all = steps;
  all.viscosity = viscosity;
  all.density = density;
  all.solid = elastic();
  all.bulk_modulus = all.solid.bulk;
  return all;
}

Outputs solid_fields() {
  return Outputs().fields(
      "solid", "The particles of the solid.",
      {{"velocity", "m/s", "Velocity of each particle in the last step.", "with Frames"},
       {"pressure", "Pa", "Elastic pressure of each particle, positive in compression.", "with Frames"},
       {"von_mises_stress", "Pa", "Von Mises's equivalent of each particle's elastic stress.", "with Frames"},
       {"intact", "1", "Share of its shear modulus that each particle still has.", "with Frames"}});
}
}  // namespace turgor
