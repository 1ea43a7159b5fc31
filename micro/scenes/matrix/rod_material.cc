#include "micro/scenes/matrix/rod_material.h"

#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <numbers>

namespace turgor {
void RodMaterial::declare(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Radius", radius, "Radius R_0 of the cell at rest, a sphere. Units: m.",
                    Double(1e-7, 1e-3));
  prm.add_parameter("Modulus", modulus, "Young's modulus of the cell in its contacts. Units: Pa.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Poisson ratio", poisson,
                    "Poisson's ratio of cell and nucleus in their contacts. Units: none.", Double(0., 0.5));
  prm.add_parameter("Nucleus radius", nucleus_radius,
                    "Radius of the nucleus, a sphere in the cell's middle that keeps its shape; 0: none. "
                    "Units: m.",
                    Double(0., 1e-3));
  prm.add_parameter("Nucleus stiffness", nucleus_ratio,
                    "Young's modulus of the nucleus over that of the cell. Units: none.", Double(1e-3, 1e6));
  prm.add_parameter("Shape stiffness", shape_stiffness,
                    "Spring constant k_cell with which a rod goes back to a sphere; 0: 4 pi/51 times modulus "
                    "and radius, that of an elastic ball stretched as far. Units: N/m.",
                    Double(0., 1e6));
  prm.add_parameter("Relaxation time", relaxation,
                    "Time mu/k_cell in which a rod goes back to a sphere by itself. Units: s.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Medium friction", medium,
                    "Friction of the cell with the medium, force over velocity; half of it at either end of "
                    "the rod. Units: N s/m.",
                    Double(1e-9, 1e6));
  prm.add_parameter("Contact friction", friction,
                    "Friction of the cell with nodes and other cells that it touches, stress over velocity; "
                    "plates are smooth. Units: N s/m^3.",
                    Double(0., 1e15));
}

void RodMaterial::declare_motion(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Tolerance", tolerance,
                    "Allowed error of a place in one step over the cell's radius; decides the length of "
                    "steps. Units: none.",
                    Double(1e-8, 1.));
  prm.add_parameter("Longest step", longest_step, "Largest step in time that is taken. Units: s.",
                    Double(1e-9, 1e12));
  prm.add_parameter("Residual", residual,
                    "Allowed residual of the equations for the velocities of a step, over the forces. Units: "
                    "none.",
                    Double(1e-9, 0.1));
  prm.add_parameter("Longest move", longest_move,
                    "Way of a particle in a step at most, over the cell's radius. Units: none.",
                    Double(1e-4, 0.2));
}

void RodMaterial::check() const {
  if (!(nucleus_radius < radius))
    throw InputError("Cell/Nucleus radius (" + number_text(1e6 * nucleus_radius) +
                     " um) has to be less than Cell/Radius (" + number_text(1e6 * radius) + " um).");
}

double RodMaterial::stiffness() const {
  return shape_stiffness > 0. ? shape_stiffness : 4. * std::numbers::pi / 51. * modulus * radius;
}

RodContactParameters RodMaterial::contacts(const ContactLaw &law, const std::uint32_t nodes,
                                           const double node_radius) const {
  return {.law = law,
          .skin = 0.1 * radius,
          .modulus = plane_modulus(),
          .nucleus_radius = nucleus_radius,
          .nucleus_modulus = nucleus_ratio * plane_modulus(),
          .nodes = nodes,
          .node_radius = node_radius,
          .normal = friction,
          .tangential = friction};
}

RodObstacleParameters RodMaterial::obstacles() const {
  return {plane_modulus(), nucleus_radius, nucleus_ratio * plane_modulus()};
}
}  // namespace turgor
