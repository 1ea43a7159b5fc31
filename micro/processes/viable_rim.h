// Who is deeper than what cells live on comes (thesis 2.2.2, 5.4.2; cell_death.h): below the surface near by
// (depth_below_surface.h) and any wall that lets it through, or below the mean edge of all. Written:
// Interval::deep.
#pragma once

#include "micro/processes/cell_life_parameters.h"
#include "micro/processes/process.h"

namespace turgor {
class ViableRim final : public Process {
 public:
  explicit ViableRim(const CellLifeParameters &parameters_) : parameters(parameters_) {}
  void change(Interval &now) override;

 private:
  const CellLifeParameters &parameters;
};
}  // namespace turgor
