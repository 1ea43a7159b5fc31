// Scene tissue_gravity: the example of thesis 3.4.3. A block of parenchyma cells,
// a square by default, W = cells times their length, clamped at x = 0, under a body force b, downwards by
// default, and a traction on the side x = W that are switched on at t = 0:
//
//   rho b W = load,   rho = density of the RVE
//
// FE^2: the stress of every quadrature point is that of an RVE (rve_law.h). Units SI.
#pragma once

#include "coupling/tissue_run.h"
#include "run/scenario.h"
#include "rve/rve_parameters.h"

namespace turgor {
class TissueGravity : public Scenario {
 public:
  TissueGravity();
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  bool uses_ranks() const override { return true; }
  void run(RunContext &context) override;

 private:
  std::array<unsigned int, 2> block() const;  ///< cells along x and y

  unsigned int cells = 16, cells_across = 0;
  double load = 20e3;  ///< Pa
  dealii::Tensor<1, 2> direction;
  TissueRunSettings settings;
  RveParameters rve_parameters;
};

std::unique_ptr<Scenario> make_tissue_gravity();
}  // namespace turgor
