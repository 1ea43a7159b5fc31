#include "coupling/static_loads.h"

#include "run/input_entries.h"

namespace turgor {
void declare_static_tool(InputEntries &prm, TissueParameters<2> &tissue, const char *section,
                         const bool none) {
  ToolParameters &tool = tissue.tool;
  tool.section = section;
  prm.add_parameter("Tool", tool.shape,
                    std::string("What presses on the side x = Width, without friction: ") +
                        (none ? "nothing, " : "") + "a plate or a cylinder. Units: none.",
                    Patterns::Selection(none ? "none|plate|cylinder" : "plate|cylinder"));
  prm.add_parameter("Radius", tool.radius, "Radius of the cylinder, with Tool = cylinder. Units: m.",
                    Patterns::Double(1e-9, 1e3));
  prm.add_parameter("Motion", tool.motion,
                    "steady: at constant speed to the depth; rebound: half a sine to the depth and back. "
                    "Units: none.");
  prm.add_parameter("Speed", tool.speed, "Speed of the tool at first contact. Units: m/s.",
                    Patterns::Double(1e-12, 1e3));
  prm.add_parameter("Depth", tool.depth, "How far the tool goes in from the first contact. Units: m.",
                    Patterns::Double(1e-12, 1e3));
  prm.add_parameter("Contact stiffness", tool.stiffness,
                    "Penalty of the contact, over the stiffness bound of the tissue per distance of nodes. A "
                    "node sinks in by pressure over that. Units: 1.",
                    Patterns::Double(1e-3, 1e3));
  prm.add_parameter("Support", tissue.left,
                    "What holds the side x = 0: clamped, or a frictionless plate on which the tissue lies "
                    "loosely (the middle of its foot does not slide). Units: none.");
}
}  // namespace turgor
