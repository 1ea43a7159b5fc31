// Laplace's law of a round cell: does the wall's tension balance the fluid's pressure?
//
//   2D   N = p R z0            tension force of the wall
//   3D   T = p R/2             tension per length, 2 pi R T = p pi R^2       thesis Eq. A.1 (corrected); the
//        thesis reaches 6 %
//
// The cell is inflated by osmosis from its stress-free state (bring_to_turgor) and both sides are measured:
// tension as pull across great circles and from the wall's virial, pressure as mean of the particles' EOS
// pressures and from the fluid's virial.
#pragma once

#include "micro/cells/round_cell.h"
#include "run/scenario.h"

namespace turgor {
class Laplace final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  template <int dim>
  void run_in(RunContext &context) const;

  unsigned int dimension = 3, samples = 100;
  RoundCellParameters cell;
};

std::unique_ptr<Scenario> make_laplace();
}  // namespace turgor
