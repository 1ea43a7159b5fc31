// The user's entries for calls of RVEs that need not be made: subsection "Skipping" (skipping.h).
#pragma once

#include "coupling/volume_law.h"

#include <cstdint>
#include <optional>

namespace turgor {
class InputEntries;
struct RveParameters;
struct SkippingSettings {
  bool certified = false;
  double tolerance = 0.;  ///< Pa; 0: share of turgor
  double share = 1e-3;    ///< of turgor
  double audit_share = 2.5e-3;
  std::uint64_t seed = 1;
  std::optional<CellContent> content;  ///< of the cells, where it is known
  double turgor = 0.;                  ///< Pa, theirs; 0: not known

  bool active() const { return certified; }
  void declare(InputEntries &prm);
  /// Throws InputError for RVEs whose answers cannot be told from F alone.
  void check(const RveParameters &rve) const;
  /// With the tolerance in Pa, the cells' content and turgor.
  SkippingSettings with(const RveParameters &rve) const;
};
}  // namespace turgor
