#include "micro/scenes/deformable/optical_stretcher.h"

#include "run/input_entries.h"
#include "run/run_context.h"
#include "run/number_text.h"

#include <algorithm>
#include <set>

namespace turgor {
std::string OpticalStretcher::milliwatts(const double power) { return number_text(1e3 * power) + "_mW"; }

void OpticalStretcher::check() const {
  std::set<std::string> names;
  for (const double power : powers)
    if (!names.insert(milliwatts(power)).second)
      throw InputError("Powers has " + number_text(power) +
                       " W twice, as far as results are named (six digits): each power makes one run.");
}

void OpticalStretcher::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Powers", powers, "Powers of each laser beam, one run for each. Units: W.",
                    List(Double(0., 100.), 1, 20));
  prm.add_parameter("Elements", elements,
                    "What the edges of the cortex are: kelvin_voigt, modified_maxwell, or both, one after "
                    "the other. Units: none.");
  prm.add_parameter("Time on", on, "Time for which the light is on. Units: s.", Double(1e-6, 1e6));
  prm.add_parameter("Time off", off, "Time for which the cell is watched afterwards. Units: s.",
                    Double(1e-6, 1e6));
  prm.add_parameter("Warming", warming,
                    "How light makes the cortex less viscous: fit (the thesis's 0.29 at 0.9 W and 0.11 at "
                    "1.1 W, exponential in the power), arrhenius (4.1 with"
                    " 55 kJ/mol, 20 K at 0.9 W and 25 K at 1.1 W above 290 K) or none. Units: none.");
  material.declare_steps(prm,
                         "the radius, and as many times less as the springs at rest would let the cell be "
                         "stretched by less than 0.5 %");
  prm.add_parameter(
      "Samples", samples,
      "Number of rows of axes.csv at least for each of the runs, spread evenly over time. Units: none.",
      Integer(1, 100000));
  prm.add_parameter("Fields", fields,
                    "Whether the surface is written when the light goes off and at the end, for pictures and "
                    "ParaView. Units: none.",
                    Bool());
  prm.enter_subsection("Beam");
  prm.add_parameter("Radius", beams.beam_radius, "Radius of the laser beams. Units: m.", Double(1e-8, 1e-2));
  prm.add_parameter("Cell index", beams.cell_index, "Refractive index n_c of the cell. Units: none.",
                    Double(1., 3.));
  prm.add_parameter("Medium index", beams.medium_index, "Refractive index n_m of the medium. Units: none.",
                    Double(1., 3.));
  prm.leave_subsection();
  prm.enter_subsection("Cell");
  material.declare_cell(prm, "");
  prm.add_parameter("Radius", radius, "Radius of the cell at rest. Units: m.", Double(1e-7, 1e-3));
  prm.add_parameter(
      "Area modulus", area_modulus,
      "Resistance K_A of each triangle against a change of its area, beside that of its edges. Units: N/m.",
      Double(0., 10.));
  prm.leave_subsection();
  const auto element = [&prm](const char *name, Element &e, const bool flows) {
    prm.enter_subsection(name);
    prm.add_parameter("Stiffness", e.stiffness, "Spring constant k of each edge. Units: N/m.",
                      Double(1e-9, 10.));
    prm.add_parameter("Bending stiffness", e.bending, "Stiffness k_b of each hinge. Units: N m.",
                      Double(0., 1e-12));
    prm.add_parameter("Friction", e.friction,
                      "Friction of the dashpot beside each spring, at 290 K. Units: N s/m.", Double(0., 10.));
    if (flows)
      prm.add_parameter("Flow friction", e.flow,
                        "Friction of the element in series with each spring, at 290 K. Units: N s/m.",
                        Double(1e-9, 1e3));
    prm.leave_subsection();
  };
  element("Kelvin-Voigt", kelvin_voigt, false);
  element("Modified Maxwell", modified_maxwell, true);
}

double OpticalStretcher::share_of_small_strain(const Element &element, const double power) const {
  LaserBeams light = beams;
  light.power = power;
  const double strain = strain_at_rest(light.stress(), radius, element.stiffness, area_modulus);
  return strain != 0. ? std::clamp(std::abs(strain) / 5e-3, 1e-6, 1.) : 1.;
}

DeformableCellParameters<LinearSpring> OpticalStretcher::cell(const Element &element,
                                                              const double power) const {
  DeformableCellParameters<LinearSpring> p;
  static_cast<DeformableMaterial &>(p) = material;
  p.spring = {element.stiffness};
  p.dashpots = element.friction;
  p.flow = element.flow;
  p.bending = element.bending;
  p.area.local = area_modulus;
  p.radius = radius;
  p.tolerance *= share_of_small_strain(element, power);
  p.first_step = 1e-4 * std::min(on, off);
  return p;
}
}  // namespace turgor
