// Scene `spreading`: a round cell laid on an adhesive plane, until it is at rest. The radius of its contact
// is compared with that of the same cell as a shell of revolution (reference/axial_shell.h), at rest by
// another method: with the contact's range of this run, which tells what the net lacks, and with a range of a
// fiftieth of the radius, which tells what that range adds.
#pragma once

#include "micro/scenes/deformable/cells_run.h"
#include "run/scenario.h"

namespace turgor {
class Spreading final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  TouchingMaterial material = [] {
    TouchingMaterial m;
    m.bulk_modulus = 2500.;
    m.tolerance = 0.05;
    m.adhesion = 1e-4;
    m.longest_step = 1e6;
    return m;
  }();
  double end = 1e8, first_step = 1e-3;
  unsigned int seed = 1;
  CellsOutput output;
};

std::unique_ptr<Scenario> make_spreading();
}  // namespace turgor
