// Mothers that are due (proliferation.h) become pairs of daughters, which halve their volume and have what is
// left of the interval; where the daughters lie: cell_division.h.
#pragma once

#include "micro/processes/cell_life_parameters.h"
#include "micro/processes/process.h"

namespace turgor {
class Division final : public Process {
 public:
  explicit Division(const CellLifeParameters &parameters_) : parameters(parameters_) {}
  void rearrange(Interval &now) override;

 private:
  /// m, of each mother to her first daughter; the second lies opposite.
  std::vector<Vector<3>> offsets(const Interval &now) const;
  void newborn(Interval &now, std::size_t i, const Vector<3> &offset, double left) const;

  const CellLifeParameters &parameters;
};
}  // namespace turgor
