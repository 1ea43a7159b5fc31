// Scene `doublet`: two round cells that adhere to each other until they are at rest. With a cortical tension
// tau the angle at which their free surfaces meet the plane between them follows from Young and Dupre, cos
// theta = 1 - W/(2 tau); without one the net of edges is compressed in the contact (thesis Fig. 4.5A).
#pragma once

#include "micro/scenes/deformable/cells_run.h"
#include "run/scenario.h"

namespace turgor {
class Doublet final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  TouchingMaterial material = [] {
    TouchingMaterial m;
    m.modulus = 10.;
    m.area_modulus = 0.;
    m.bulk_modulus = 2e4;
    m.tension = 1e-3;
    m.tolerance = 0.05;
    m.adhesion = 4e-4;
    m.longest_step = 100.;
    m.dashpots = 1e-2;  // as in cell_between_plates
    m.range = 0.75e-6;
    return m;
  }();
  double end = 2000., first_step = 1e-3;
  unsigned int seed = 1;
  CellsOutput output;
};

std::unique_ptr<Scenario> make_doublet();
}  // namespace turgor
