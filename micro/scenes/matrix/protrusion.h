// Scene `protrusion`: one protrusion between a held cell and a node of the matrix on a spring k_ECM, one for
// each of Stiffnesses (thesis 2.3.3, Fig. 2.10B): force in steps of the stall force, number of bonds, until
// the work limit (2.41), and letting out. Beside them the closed form of the steps
// (reference/stall_steps.h) and the bonds of the mean field at rest.
#pragma once

#include "micro/scenes/matrix/rod_cells.h"
#include "run/scenario.h"

namespace turgor {
class ProtrusionScene final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  std::vector<double> stiffnesses{1e-4, 1e-3, 1e-2, 1e-1};
  double length = 6e-6, fibre = 6e-6, node_friction = 1e-6;
  unsigned int samples = 400, checkpoints = 4;
  ProtrusionLaw law;
  RodMaterial cell = [] {
    RodMaterial m;
    m.longest_step = 0.005;
    return m;
  }();
};

std::unique_ptr<Scenario> make_protrusion();
}  // namespace turgor
