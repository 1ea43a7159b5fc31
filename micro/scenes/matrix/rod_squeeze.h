// Scene `rod_squeeze`: a cell of the rod model squeezed between two plates (thesis 2.3.3, Fig. 2.9D, there by
// two barriers of matrix): it gets longer and thinner, at its volume, until its nucleus holds against the
// plates. Force and length stand beside the balance in closed form (reference/squeezed_rod.h) and its two
// limits, a body that keeps its sphere and a contact without depth.
#pragma once

#include "micro/scenes/deformable/cells_run.h"
#include "micro/scenes/matrix/rod_cells.h"
#include "micro/scenes/plate_descent.h"
#include "micro/scenes/reference/squeezed_rod.h"
#include "run/scenario.h"

namespace turgor {
class RodSqueeze final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  SqueezedRod reference() const;

  RodMaterial cell;
  PlateDescent plates{.distance = 5e-6, .compression = 600., .hold = 600.};
  double angle = 20.;  ///< degrees
  CellsOutput output;
};

std::unique_ptr<Scenario> make_rod_squeeze();
}  // namespace turgor
