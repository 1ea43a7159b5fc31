// Scene tissue_bruise: a block of parenchyma [0, width] x [0, height], clamped at x = 0 or on a plate there,
// is hit at x = width by a rigid plate or cylinder (rigid_tools.h), at 5 m/s by default, as fruit is
// (thesis 3.3.3). FE^2: at every quadrature point an RVE whose walls yield and break and whose cells fail
// (wall_history.h); where cells have failed the tissue is bruised. Units SI, per metre of depth.
#pragma once

#include "coupling/tissue_run.h"
#include "run/scenario.h"
#include "rve/rve_parameters.h"

namespace turgor {
class TissueBruise : public Scenario {
 public:
  TissueBruise();
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  bool uses_ranks() const override { return true; }
  void run(RunContext &context) override;

 private:
  TissueRunSettings settings;
  RveParameters rve_parameters;
};

std::unique_ptr<Scenario> make_tissue_bruise();
}  // namespace turgor
