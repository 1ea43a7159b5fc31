// Scene `capsule_compression`: a compact clump of deformable cells in a rigid sphere that shrinks, then
// stands still. Volume strain, pressure inside the cells and on the wall, how near surfaces come to each
// other.
#pragma once

#include "micro/scenes/deformable/cells_run.h"
#include "run/scenario.h"

namespace turgor {
class CapsuleCompression final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  std::vector<Vector<3>> places() const;  ///< m, of the cells' centres
  double first_radius() const;            ///< m, of the sphere, which the outermost cells just touch

  TouchingMaterial material = [] {
    TouchingMaterial m;
    m.nu = 4;
    m.bulk_modulus = 2500.;
    m.tolerance = 0.05;
    m.longest_step = 20.;
    m.range = 0.4e-6;
    return m;
  }();
  unsigned int count = 13, seed = 1;
  double last_radius = 22.1e-6, compression = 1800., hold = 600.;
  CellsOutput output;
};

std::unique_ptr<Scenario> make_capsule_compression();
}  // namespace turgor
