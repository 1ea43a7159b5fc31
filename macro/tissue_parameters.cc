#include "macro/tissue_parameters.h"

#include "run/input_entries.h"
#include "run/entry_marks.h"
#include "run/number_text.h"

#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
constexpr const char *size_names[] = {"Width", "Height", "Depth"};
constexpr int most_elements = 4096;  // along a direction
constexpr const char *axis_names[] = {"x", "y", "z"};
}  // namespace

template <int dim>
TissueParameters<dim>::TissueParameters() {
  size.fill(1.6e-3);
  elements.fill(8);
}

template <int dim>
void TissueParameters<dim>::declare(InputEntries &prm, bool with_size_and_body_force) {
  declare_piece(prm, with_size_and_body_force);
  declare_time(prm);
}

template <int dim>
void TissueParameters<dim>::declare_piece(InputEntries &prm, bool with_size_and_body_force) {
  const EntryPattern vector = Patterns::List(Patterns::Double(), dim, dim);

  prm.enter_subsection("Tissue");
  for (unsigned int d = 0; d < dim && with_size_and_body_force; ++d)
    prm.add_parameter(size_names[d], size[d],
                      "Size of the undeformed piece along " + std::string(axis_names[d]) + ". Units: m.",
                      Patterns::Double(1e-9, 1e3));
  for (unsigned int d = 0; d < dim; ++d)
    prm.add_parameter("Elements " + std::string(axis_names[d]), elements[d],
                      "Number of finite elements along " + std::string(axis_names[d]) + ". Units: 1.",
                      Patterns::Integer(1, most_elements));
  prm.add_parameter("Degree", degree,
                    "Polynomial degree of the elements: 1 bilinear, 2 biquadratic. Units: 1.",
                    Patterns::Integer(1, 2));
  prm.add_parameter(
      "Locking treatment", locking,
      "f_bar: volume change of one order lower than the shape change, so that nearly incompressible tissue "
      "bends freely; full: plain full integration. Units: none.");
  prm.add_parameter(
      "Lateral sides", lateral,
      "The sides normal to y (and z): free, periodic (a slab without end) or clamped. Units: none.");
  prm.add_parameter("Right side", right,
                    "The side x = Width: free or clamped. The side x = 0 is always clamped. Units: none.");
  if (with_size_and_body_force)
    prm.add_parameter("Body force", body_force,
                      "Force per mass, switched on at t = 0: one number per direction. Units: N/kg.", vector);
  prm.add_parameter(
      "Traction", traction,
      "Force per reference area on the side x = Width, switched on at t = 0: one number per direction. "
      "Units: Pa.",
      vector);
  prm.leave_subsection();
}

template <int dim>
void TissueParameters<dim>::declare_time(InputEntries &prm) {
  prm.enter_subsection("Time");
  prm.add_parameter("Integrator", integrator,
                    "central_differences: second order, one stress evaluation a step; dormand_prince: the "
                    "thesis's adaptive "
                    "Runge-Kutta 5(4) of SUNDIALS. Units: none.");
  prm.add_parameter("End time", end_time, end_of_run("Simulated time after which the run ends. Units: s."),
                    Patterns::Double(1e-12, 1e6));
  prm.add_parameter(
      "Step fraction", cfl,
      "Time step over the largest that is stable; smaller is more accurate and slower. Units: 1.",
      Patterns::Double(0.01, 1.));
  prm.rename("CFL fraction", "Step fraction");
  prm.add_parameter("Shock viscosity", shock_viscosity,
                    "Viscous pressure of elements that are being compressed, over the usual one, 1.5 rho l^2 "
                    "D^2 - 0.06 rho c "
                    "l D (l: distance of nodes, D: rate of volume, c: speed of waves). A blow that drives a "
                    "front through the "
                    "tissue, where air spaces close or cells stiffen, loses energy there; with 1 elements "
                    "neither ring behind "
                    "the front nor let it run ahead. 0: none. Units: 1.",
                    Patterns::Double(0., 100.));
  prm.add_parameter(
      "Steps between estimates", estimate_every,
      "The stable step is found anew from the tangents of the law after this many steps; 0 uses only the "
      "law's bounds, which is safe but gives shorter steps. Units: 1.",
      Patterns::Integer(0, 1000000));
  prm.add_parameter(
      "Relative tolerance", relative_tolerance,
      "Allowed local error of a step of dormand_prince, relative to displacement and velocity. Units: 1.",
      Patterns::Double(1e-14, 1.));
  prm.add_parameter("Displacement tolerance", displacement_tolerance,
                    "Allowed local error of the displacement in a step of dormand_prince, added to the "
                    "relative one. Units: m.",
                    Patterns::Double(1e-18, 1.));
  prm.add_parameter("Velocity tolerance", velocity_tolerance,
                    "Allowed local error of the velocity in a step of dormand_prince, added to the relative "
                    "one. Units: m/s.",
                    Patterns::Double(1e-15, 1e3));
  prm.add_parameter("Output interval", output_interval,
                    "Simulated time between two pictures of the fields; steps end on them. Units: s.",
                    Patterns::Double(1e-12, 1e6));
  prm.add_parameter(
      "Checkpoint interval", checkpoint_interval,
      free_to_change("Wall time between two checkpoints, from which --resume goes on. Units: s."),
      Patterns::Double(0., 1e6));
  prm.leave_subsection();
}

// Only nodes feel the tool: one thinner than their spacing finds its way between them and meets no force.
template <int dim>
void TissueParameters<dim>::check_cylinder() const {
  const unsigned int parts = elements[1] * degree;
  const double spacing = size[1] / parts;
  constexpr double rounding = 1. - 1e-12;
  if (tool.radius < spacing * rounding) {
    const double needed = std::ceil(size[1] / (tool.radius * degree) * rounding);
    throw std::invalid_argument(
        std::string(tool.section) + "/Radius is " + number_text(tool.radius) + " m, less than the " +
        number_text(spacing, 3) +
        " m between two nodes of the surface: the cylinder would slip through between them. Take a larger "
        "one" +
        (needed <= most_elements ? " or 'Tissue/Elements y' of at least " + number_text(needed) : "") + ".");
  }
  // With an even number of parts a node is below its lowest point.
  const double aside = parts % 2 == 0 ? 0. : 0.5 * spacing;
  if (!(tool.radius - std::sqrt(tool.radius * tool.radius - aside * aside) < tool.depth))
    throw std::invalid_argument("With Tissue/Elements y = " + number_text(elements[1]) +
                                " the cylinder comes down between two nodes and, at " + tool.section +
                                "/Depth = " + number_text(tool.depth * 1e3) +
                                " mm, touches neither; take more elements, or an even number of them.");
}

template <int dim>
void TissueParameters<dim>::check() const {
  for (unsigned int d = 0; d < dim; ++d) {
    if (!std::isfinite(body_force[d]))
      throw std::invalid_argument("Tissue/Body force must be " + number_text(dim) +
                                  " finite numbers (N/kg).");
    if (!std::isfinite(traction[d]))
      throw std::invalid_argument("Tissue/Traction must be " + number_text(dim) + " finite numbers (Pa).");
  }
  if (right == RightSide::clamped && traction.norm() > 0.)
    throw std::invalid_argument(
        "Tissue/Traction acts on the side x = Width, so it needs 'Right side = free' "
        "(it is 'clamped').");
  if (right == RightSide::clamped && tool.active())
    throw std::invalid_argument(
        "A tool acts on the side x = Width, so it needs 'Right side = free' (it is 'clamped').");
  tool.check(size[0]);
  if (tool.shape == ToolShape::cylinder && tool.active()) check_cylinder();
  if (tool.active() && lateral == LateralSides::clamped)
    for (unsigned int d = 1; d < dim; ++d)
      if (elements[d] * degree < 2)
        throw std::invalid_argument(
            "With Tissue/Elements " + std::string(axis_names[d]) +
            " = 1, degree 1 and 'Lateral sides = clamped' every node that the tool touches is held "
            "and nothing can move; take more elements or other lateral sides.");
  if (lateral == LateralSides::periodic)
    for (unsigned int d = 1; d < dim; ++d)
      if (elements[d] * degree < 2)
        throw std::invalid_argument("Tissue/Elements " + std::string(axis_names[d]) +
                                    " must be at least 2 with 'Lateral sides = periodic' and degree 1.");
}

template struct TissueParameters<2>;
template struct TissueParameters<3>;
}  // namespace turgor
