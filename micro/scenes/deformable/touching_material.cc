#include "micro/scenes/deformable/touching_material.h"

#include "run/input_entries.h"
#include "run/judged.h"

#include <numbers>

namespace turgor {
void TouchingMaterial::declare_motion(InputEntries &prm) {
  declare_steps(prm, "the radius");
  prm.add_parameter("Residual", residual,
                    "Allowed residual of the equations for the velocities of a step, over the forces; net "
                    "force and torque of cells that touch are exact whatever it is. Units: none.",
                    Patterns::Double(1e-9, 0.1));
}

void TouchingMaterial::declare_cortex(InputEntries &prm) {
  using namespace Patterns;
  declare_cell(prm, "");
  prm.add_parameter("Radius", radius, "Radius of the cell, a sphere free of stress. Units: m.",
                    Double(1e-7, 1e-3));
  prm.add_parameter("Cortex modulus", modulus,
                    "Young's modulus E of the cortex; each edge is a spring of (sqrt 3/2) E h. Units: Pa.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Cortex thickness", thickness, "Thickness h of the cortex. Units: m.",
                    Double(1e-9, 1e-4));
  prm.add_parameter("Cortex Poisson ratio", poisson,
                    "Poisson's ratio in the bending stiffness of the cortex, E h^3/(12 (1 - nu^2)); a net of "
                    "springs has 1/3 in its plane. Units: none.",
                    Double(0., 0.5));
  prm.add_parameter(
      "Area modulus", area_modulus,
      "Resistance K_A of each triangle against a change of its area, beside that of its edges. Units: N/m.",
      Double(0., 10.));
  prm.add_parameter("Cortex tension", tension,
                    "Active tension tau that the cortex makes, whatever its area. Units: N/m.",
                    Double(0., 1.));
  prm.add_parameter("Cortex friction", dashpots,
                    "Friction of the dashpot along each edge of the cortex. Units: N s/m.", Double(0., 10.));
}

void TouchingMaterial::declare_contact(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Adhesion", adhesion, "Energy W that an area of contact is worth. Units: J/m^2.",
                    Double(0., 1.));
  prm.add_parameter("Range", range,
                    "How far beyond the gap at rest adhesion and friction are felt; 0: half of a mean "
                    "edge, which is as short as the net resolves, but no less than 20 nm. Units: m.",
                    Double(0., 1e-4));
  prm.add_parameter("Gap at rest", rest,
                    "Gap between surfaces that touch without force, of the order of the cortex. Units: m.",
                    Double(1e-9, 1e-4));
  prm.add_parameter(
      "Stiffness", stiffness,
      "Resistance of contacts against less than the gap at rest: pressure over it. Units: N/m^3.",
      Double(1e3, 1e15));
  prm.add_parameter("Friction", friction,
                    "Friction of surfaces in contact, stress over velocity. Units: N s/m^3.",
                    Double(0., 1e15));
  prm.add_parameter("Longest move", longest_move,
                    "Way of a node in a step at most, over the radius. Units: none.", Double(1e-4, 0.2));
}

void TouchingMaterial::declare_blend(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Blend", blend,
      "Length over which the nearest triangle of another cell is blended with its neighbours, so "
      "that forces do not jump from one to the next. Units: m.",
      Double(1e-9, 1e-5));
}

double TouchingMaterial::edge() const {
  return radius / double(nu) * std::sqrt(4. * std::numbers::pi / 20. * 4. / std::sqrt(3.));
}

SurfaceAdhesion TouchingMaterial::law() const {
  return {adhesion, range > 0. ? range : SurfaceAdhesion::range_for(edge(), 20e-9), rest, stiffness};
}

double TouchingMaterial::mesh_ratio() const {
  return edge() * std::sqrt(adhesion / (0.5 * std::sqrt(3.) * hinge()));
}

// What is advised holds for the net that there is: a range of less than half an edge is not resolved.
void TouchingMaterial::check_reach() const {
  const double most = 0.25 * radius, left = most - rest, shortest = SurfaceAdhesion::range_for(edge(), 20e-9);
  if (law().reach() <= most) return;
  const std::string said = "Contact/Gap at rest and Contact/Range are felt up to " +
                           number_text(1e6 * law().reach()) + " um from a surface, more than a quarter of " +
                           "Cell/Radius (" + number_text(1e6 * radius) + " um): ";
  if (!(left > 20e-9))
    throw InputError(said + "make Contact/Gap at rest smaller, it alone is " + number_text(1e6 * rest) +
                     " um.");
  if (shortest <= left)
    throw InputError(said + "make Contact/Range shorter, from " + number_text(1e6 * shortest) +
                     " um (half of an edge, no shorter one is resolved) to " + number_text(1e6 * left) +
                     " um.");
  throw InputError(said + "use a finer net, Cell/Frequency of at least " +
                   number_text(std::ceil(nu * shortest / left)) +
                   ", and Contact/Range = 0 (half of its edges): on this net a range that is short enough is "
                   "not resolved.");
}

void TouchingMaterial::check_contact() const {
  check_reach();
  const double sagitta = edge() * edge() / (8. * radius);
  if (rest < sagitta)
    throw InputError("Contact/Gap at rest is " + number_text(1e6 * rest) +
                     " um, less than the net's triangles deviate from the sphere (" +
                     number_text(1e6 * sagitta) +
                     " um): surfaces would cross unseen. Use a larger gap or a finer net (Cell/Frequency).");
}

AxialShellParameters TouchingMaterial::shell() const {
  return {radius, spring(), hinge(), area_modulus, tension, bulk_modulus, law()};
}

void judge_mesh(RunContext &context, const TouchingMaterial &material) {
  const double ratio = material.mesh_ratio();
  context.result("mesh_ratio", ratio, "1");
  std::string text;
  if (ratio > 1.5)
    text = "an edge is " + number_text(ratio, 3) +
           " times the length sqrt(D/W) in which adhesion bends the cortex at the rim of a contact: above "
           "1.5 contacts peel in jumps of the net, and the force that tears them apart comes out too high "
           "(finer net: Cell/Frequency)";
  if (material.adhesion > 0. && material.law().range < 0.45 * material.edge())
    text += std::string(text.empty() ? "" : "; ") + "Contact/Range is " +
            number_text(material.law().range / material.edge(), 3) +
            " of an edge: below a half the rim of a contact is caught between nodes (Contact/Range = 0, or a "
            "finer net)";
  if (!text.empty()) remarked(context, "mesh_ratio", text);
}
}  // namespace turgor
