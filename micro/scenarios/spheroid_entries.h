// Entries of all scenes with centre-based cells that grow: subsections Cell, Contact, Growth, Division, Death and Motion.
// Defaults are CT26 cells (thesis Table C.2, with errata where it contradicts the text).
#pragma once

#include "micro/scenarios/cell_culture.h"

namespace turgor
{
class InputEntries;
/// What the entries say, words not yet turned into laws.
struct CultureEntries
{
  CultureParameters numbers;
  std::string rate = "constant", inhibition = "hill", division_at = "size", direction = "least_stress", axis = "0, 0, 1",
              distance = "least_energy", rim = "none", lysis = "delayed", method = "heun",
              stiffness = "none", compression = "cell";
  std::string preferred = "0, 0, 0";
  double seed = 1.;
  bool in_plane = false; ///< of a monolayer; not an entry

  void declare(InputEntries &prm);
  /// Throws InputError.
  void check() const;
  CultureParameters parameters() const;
};
} // namespace turgor
