// What every scene of a deformable cell says alike, whatever its edges are made of: how fine its net is, what
// is in it and around it, how it is stepped. Entries are declared once, here.
//
//   template <class Spring> struct DeformableCellParameters : DeformableMaterial { ... };
//   DeformableMaterial material; material.declare_steps(prm, "the radius");
//   prm.enter_subsection("Cell"); material.declare_cell(prm, " of half the diameter"); ...
#pragma once

#include <string>

namespace turgor {
class InputEntries;

struct DeformableMaterial {
  unsigned int nu = 8;        ///< parts of each edge of the icosahedron
  double bulk_modulus = 0.;   ///< Pa, of the content
  double viscosity = 1e-3;    ///< Pa s, mu of the medium
  double tolerance = 1e-3;    ///< error of a step over the radius
  double longest_step = 1e9;  ///< s

  /// Tolerance and Longest step, in the current subsection of prm. length: what errors are measured by.
  void declare_steps(InputEntries &prm, const std::string &length);
  /// Frequency, Bulk modulus, Medium viscosity. radius: what follows on "6 pi mu R", where R is no entry.
  void declare_cell(InputEntries &prm, const std::string &radius);
};
}  // namespace turgor
