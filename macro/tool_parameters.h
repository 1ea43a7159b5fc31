// What the user says about the tool that hits the tissue (rigid_tools.h).
#pragma once

#include <string>

namespace turgor
{
class InputEntries;
struct ToolParameters
{
  std::string shape = "none";       ///< none | plate | cylinder
  double radius = 1e-3;             ///< m, of the cylinder
  std::string motion = "rebound";   ///< steady | rebound
  double speed = 5.;                ///< m/s, at first contact
  double depth = 0.2e-3;            ///< m, largest travel
  double stiffness = 1.;            ///< kappa * distance of nodes / stiffness bound of the law

  bool active() const { return shape != "none"; }
  double travel(double time) const;

  /// s; a longer step does not see the tool come and go, and makes energy of that.
  double longest_step() const; ///< m, s(t)

  /// Declares the entries in the current subsection.
  void declare(InputEntries &prm);
  /// What the patterns cannot say; std::invalid_argument. width: m, of the piece.
  void check(double width) const;
};
} // namespace turgor
