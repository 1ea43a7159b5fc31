// Scene `cell_between_plates`: a round cell with a tense cortex squeezed between two parallel plates that it
// does not adhere to, as mitotic cells under a flat cantilever are (E. Fischer-Friedrich et al. 2014,
// 10.1038/srep06213). Tension and pressure are taken from the plates' force and distance and the cell's
// widest radius, as the experiment takes them, by Laplace's law of a liquid drop (reference/squeezed_drop.h),
// and compared with those that were put in.
#pragma once

#include "micro/scenes/deformable/cells_run.h"
#include "micro/scenes/plate_descent.h"
#include "run/scenario.h"

namespace turgor {
class CellBetweenPlates final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  TouchingMaterial material = [] {
    TouchingMaterial m;
    m.bulk_modulus = 2e4;
    m.modulus = 100.;
    m.area_modulus = 0.;
    m.tension = 1.6e-3;
    m.tolerance = 0.02;
    m.longest_step = 1.;
    // Active tension lets nodes slide in the surface, which no matrix of implicit steps sees: with weaker
    // dashpots it makes energy in steps of a tenth of a second.
    m.dashpots = 1e-3;
    m.friction = 0.;
    return m;
  }();
  PlateDescent plates{.distance = 13e-6, .compression = 60., .hold = 120.};
  unsigned int seed = 1;
  CellsOutput output;
};

std::unique_ptr<Scenario> make_cell_between_plates();
}  // namespace turgor
