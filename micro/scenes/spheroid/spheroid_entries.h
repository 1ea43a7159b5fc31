// Entries of all scenes with centre-based cells that grow: subsections Cell, Contact, Growth, Division, Death
// and Motion. Defaults are CT26 cells (thesis Table C.2, with errata where it contradicts the text; Poisson's
// ratio from K = E/(3 (1 - 2 nu)), C.1). What a scene needs otherwise its constructor sets: its defaults are
// those of its input in inputs/.
#pragma once

#include "micro/scenes/spheroid/cell_culture.h"

namespace turgor {
class InputEntries;
/// What the entries say; texts not yet turned into vectors and tables.
struct CultureEntries {
  CultureParameters numbers;
  std::string axis = "0, 0, 1", stiffness = "none", preferred = "0, 0, 0";
  double seed = 1.;
  CultureEntries() { numbers.life.poisson = 0.485; }
  /// Implicit steps for crowded cells, as long as the root mean square of all their errors allows
  /// (spheroid_scene.h's studies use them).
  void step_coarsely();
  bool in_plane = false;  ///< of a monolayer; not an entry

  void declare(InputEntries &prm);
  /// Throws InputError.
  void check() const;
  CultureParameters parameters() const;

 private:
  void declare_cell(InputEntries &prm);
  void declare_contact(InputEntries &prm);
  void declare_growth(InputEntries &prm);
  void declare_division(InputEntries &prm);
  void declare_death(InputEntries &prm);
  void declare_motion(InputEntries &prm);
};
}  // namespace turgor
