// What the user says about the tool that hits the tissue (rigid_tools.h).
#pragma once

#include "run/choice.h"

namespace turgor {
class InputEntries;
enum class ToolShape { none, plate, cylinder };
constexpr const char *words_of(ToolShape) { return "none|plate|cylinder"; }

enum class ToolMotion { steady, rebound };
constexpr const char *words_of(ToolMotion) { return "steady|rebound"; }

struct ToolParameters {
  ToolShape shape = ToolShape::none;
  double radius = 1e-3;  ///< m, of the cylinder
  ToolMotion motion = ToolMotion::rebound;
  double speed = 5.;      ///< m/s, at first contact
  double depth = 0.2e-3;  ///< m, largest travel
  double stiffness = 1.;  ///< kappa * distance of nodes / wave modulus of the law
  double damping = 0.3;   ///< of a node on its penalty, over the critical

  const char *section = "Impact";  ///< of the input, as messages name it

  bool active() const { return shape != ToolShape::none; }
  double travel(double time) const;

  /// s; a longer step does not see the tool come and go, and makes energy of that.
  double longest_step() const;  ///< m, s(t)

  /// Declares the entries in the current subsection.
  void declare(InputEntries &prm);
  /// What the patterns cannot say; std::invalid_argument. width: m, of the piece.
  void check(double width) const;
};
}  // namespace turgor
