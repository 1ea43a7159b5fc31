// The scene that has every cell where a scene of finite elements has RVEs: the same tissue, load and length
// of time, for `turgor compare`.
//
//   tissue_statics   static_lattice: every wall of every cell at rest
//   tissue_gravity   full_micro: all cells as particles
//   tissue_bruise    tissue_impact: all cells as particles, struck by a plate (struck_counterpart.h)
//
//   const Counterpart cells = counterpart_of(load_input(file, {}, registry), registry);
//
// Entries of the same name (Cell, Structure, SPH) have the values that they have there.
#pragma once

#include "app/input.h"

#include <string>
#include <utility>
#include <vector>

namespace turgor {
struct Counterpart {
  using Entries = std::vector<std::pair<std::string, std::string>>;

  std::string scene;
  Entries entries;  ///< Section/Name and value: all that differ from the scene's own defaults
  bool has_sides;   ///< sides that are free in the tissue: there is a surface effect to tell
  bool moves;       ///< a swing is compared, else a state at rest
  /// Half as many cells along either side, half as long: what goes with 1/n is told by it. Empty where the
  /// number cannot be halved.
  Entries half;
  /// Each with what it is called: changes of the input of finite elements, one at a time, each of which
  /// should change nothing.
  std::vector<std::pair<std::string, Entries>> refinements;
  std::string remark = {};  ///< on what the error is first of all; empty: nothing
  bool struck = false;      ///< a blow is compared (blow.csv), and does not count as a swing
  bool breaks = false;      ///< its walls may break: failed cells are compared
  Entries tissue = {};      ///< changes of the input of finite elements without which there is no such scene
  double cpu = 0.;          ///< s, that all cells will take, roughly; 0: not known
  bool along_x = false;     ///< the load pushes more along x than along y: that displacement is compared
};

/// Throws InputError with a sentence where there is no such scene, or it cannot have what the input asks for.
Counterpart counterpart_of(const Input &tissue, const ScenarioRegistry &registry);
}  // namespace turgor
