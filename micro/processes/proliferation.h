// Living cells rest or go on in their cycle and grow (cell_cycle.h, cell_growth.h, thesis 5.3.1 H.III,
// C.3.2); who comes to the end of the cycle is due to divide (Interval::divisions). Columns of a cell: phase
// (none), cycle_time (s), strain (none). Of a sphere: reference_volume (m^3).
#pragma once

#include "micro/processes/cell_life_parameters.h"
#include "micro/processes/process.h"

namespace turgor {
class Proliferation final : public Process {
 public:
  explicit Proliferation(const CellLifeParameters &parameters_) : parameters(parameters_) {}
  void declare(Particles<3> &particles) const override {
    particles.declare("reference_volume");
    for (const char *name : {"phase", "cycle_time"}) particles.cells.declare(name);
  }
  void change(Interval &now) override {
    CellPopulation &cells = now.cells;
    Table &table = cells.particles.cells;
    std::vector<double> &V_ref = cells.particles.field("reference_volume"), &phase = table.column("phase");
    const std::vector<double> &T = table.column("cycle_time"), &eps = table.column("strain");
    const CellStates state = cells.state();
    const CellCycle &cycle = parameters.cycle;
    const double V_0 = parameters.birth_volume();
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
      if (!state.alive(i)) continue;
      const bool held = now.deep[i] && parameters.death.rim == Rim::quiescent;
      const double before = V_ref[i];
      const CellCycle::Lived lived =
          cycle.live(parameters.growth, V_0, T[i], eps[i], state[i] == CellState::quiescent, held, now.dt,
                     phase[i], V_ref[i]);
      cells.set_state(i, lived.rests ? CellState::quiescent : CellState::proliferating);
      now.count.grown += V_ref[i] - before;
      if (lived.left >= 0.) now.divisions.push_back({i, lived.left});
    }
  }

 private:
  const CellLifeParameters &parameters;
};
}  // namespace turgor
