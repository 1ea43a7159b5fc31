// Entries of scenes of migration (migration_trial.h), the same in all that have them.
//
//   TrialEntries entries;   entries.declare(prm);   entries.check();   MigrationTrial(entries.parameters(),
//   ...)
#pragma once

#include "micro/scenes/matrix/migration_trial.h"

#include <string>

namespace turgor {
class InputEntries;

struct TrialEntries {
  TrialParameters trial = [] {
    TrialParameters p;
    p.cell.longest_step = 1.;
    return p;
  }();
  std::string law = "hertz";
  double adhesion = 0.;

  void declare(InputEntries &prm);
  /// Throws InputError for what cannot be laid or reaches nothing.
  void check() const;
  TrialParameters parameters() const;

 private:
  void declare_matrix(InputEntries &prm);
  void declare_search(InputEntries &prm);
};
}  // namespace turgor
