#include "macro/tool_parameters.h"

#include "run/input_entries.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace turgor {
double ToolParameters::travel(const double time) const {
  if (motion == ToolMotion::steady) return std::min(speed * time, depth);
  const double phase = speed * time / depth;
  // back at the surface it goes on as it came
  return phase < std::numbers::pi ? depth * std::sin(phase) : -(speed * time - std::numbers::pi * depth);
}

double ToolParameters::longest_step() const {
  constexpr double steps_to_the_depth = 20.;
  return active() ? depth / (speed * steps_to_the_depth) : std::numeric_limits<double>::infinity();
}

void ToolParameters::declare(InputEntries &prm) {
  prm.add_parameter("Tool", shape, "What hits the side x = Width: a plate or a cylinder. Units: none.",
                    Patterns::Selection("plate|cylinder"));
  prm.add_parameter("Radius", radius, "Radius of the cylinder that hits, with Tool = cylinder. Units: m.",
                    Patterns::Double(1e-9, 1e3));
  prm.add_parameter("Motion", motion,
                    "steady: at constant speed to the depth, then at rest; rebound: half a sine to the depth "
                    "and back, as a mass "
                    "moves on a spring. Units: none.");
  prm.add_parameter("Speed", speed, "Speed of the tool at first contact, at t = 0. Units: m/s.",
                    Patterns::Double(1e-9, 1e3));
  prm.add_parameter("Depth", depth, "How far the tool goes in from the first contact. Units: m.",
                    Patterns::Double(1e-12, 1e3));
  prm.add_parameter(
      "Contact stiffness", stiffness,
      "Penalty of the contact, over the tissue's stiffness to plane waves per distance of nodes. A "
      "node sinks in by "
      "pressure over that; the stable step shrinks as it grows. Units: 1.",
      Patterns::Double(1e-3, 1e3));
  prm.add_parameter(
      "Contact damping", damping,
      "Dashpot of the contact, over what is critical for a node on its penalty: without it the nodes that a "
      "tool hits swing on their penalty, and so does the force. It takes the energy of that swing, as heat; "
      "explicit steps (Integrator = central_differences) have it. Units: 1.",
      Patterns::Double(0., 10.));
}

void ToolParameters::check(const double width) const {
  const auto wrong = [this](const char *entry, const double value, const std::string &allowed) {
    std::ostringstream text;
    text << section << "/" << entry << " is " << value << "; allowed is " << allowed << ".";
    throw std::invalid_argument(text.str());
  };
  if (!active()) return;
  if (!(speed > 0.)) wrong("Speed", speed, "a positive speed (m/s)");
  if (!(depth > 0. && depth < 0.9 * width))
    wrong("Depth", depth,
          "more than 0 and less than nine tenths of the tissue's width, " + number_text(width * 1e3) +
              " mm (m)");
  if (shape == ToolShape::cylinder && !(radius > 0.)) wrong("Radius", radius, "a positive radius (m)");
  if (!(stiffness > 0.)) wrong("Contact stiffness", stiffness, "a positive number");
}
}  // namespace turgor
