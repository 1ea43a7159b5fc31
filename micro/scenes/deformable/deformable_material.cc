#include "micro/scenes/deformable/deformable_material.h"

#include "run/input_entries.h"

namespace turgor {
void DeformableMaterial::declare_steps(InputEntries &prm, const std::string &length) {
  using namespace Patterns;
  prm.add_parameter("Tolerance", tolerance,
                    "Allowed error of a node's place in one step over " + length +
                        "; decides the length of steps. Units: none.",
                    Double(1e-8, 1.));
  prm.add_parameter("Longest step", longest_step, "Largest step in time that is taken. Units: s.",
                    Double(1e-9, 1e12));
}

void DeformableMaterial::declare_cell(InputEntries &prm, const std::string &radius) {
  using namespace Patterns;
  prm.add_parameter("Frequency", nu,
                    "Parts nu of each edge of the icosahedron that the net is made of; it has 10 nu^2 + 2 "
                    "nodes. Units: none.",
                    Integer(2, 60));
  prm.add_parameter("Bulk modulus", bulk_modulus,
                    "Resistance K of the content against a change of its volume. Units: Pa.",
                    Double(0., 1e9));
  prm.add_parameter(
      "Medium viscosity", viscosity,
      "Viscosity mu of the medium; the nodes share the drag 6 pi mu R" + radius + ". Units: Pa s.",
      Double(1e-6, 1e6));
}
}  // namespace turgor
