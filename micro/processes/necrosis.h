// Living cells below the viable rim die when their pressure reaches their own threshold (cell_death.h,
// thesis 5.3.1 H.I). Column of a cell: volume_at_death (m^3), with necrosis.
#pragma once

#include "micro/processes/cell_life_parameters.h"
#include "micro/processes/process.h"

namespace turgor {
class Necrosis final : public Process {
 public:
  explicit Necrosis(const CellLifeParameters &parameters_) : parameters(parameters_) {}
  void declare(Particles<3> &particles) const override {
    if (parameters.death.rim == Rim::necrotic) particles.cells.declare("volume_at_death");
  }
  void change(Interval &now) override {
    const CellDeath &death = parameters.death;
    if (death.rim != Rim::necrotic) return;
    CellPopulation &cells = now.cells;
    const std::vector<double> &V_ref = cells.particles.field("reference_volume");
    std::vector<double> &V_at_death = cells.particles.cells.column("volume_at_death");
    const CellStates state = cells.state();
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (state.alive(i) && now.deep[i] &&
          death.dies(
              HUGE_VAL, now.pressure[i],
              parameters.variability(death.necrosis_pressure, cells.id()[i], Varied::necrosis_pressure))) {
        V_at_death[i] = V_ref[i];
        cells.set_state(i, CellState::necrotic);
        ++now.count.deaths;
      }
  }

 private:
  const CellLifeParameters &parameters;
};
}  // namespace turgor
