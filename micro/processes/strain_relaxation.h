// The volumetric strain of living cells goes towards that at rest under their pressure (cell_volume.h, thesis
// C.1, C.3) with T_rel. Columns of a cell: strain (none), bulk_modulus (Pa).
#pragma once

#include "micro/processes/cell_life_parameters.h"
#include "micro/processes/process.h"

namespace turgor {
class StrainRelaxation final : public Process {
 public:
  explicit StrainRelaxation(const CellLifeParameters &parameters_) : parameters(parameters_) {}
  void declare(Particles<3> &particles) const override {
    particles.cells.declare("strain");
    particles.cells.declare("bulk_modulus");
  }
  void change(Interval &now) override {
    Table &cells = now.cells.particles.cells;
    std::vector<double> &eps = cells.column("strain");
    const std::vector<double> &K = cells.column("bulk_modulus");
    const CellStates state = now.cells.state();
    for (std::size_t i = 0; i < eps.size(); ++i)
      if (state.alive(i))
        eps[i] = relaxed_strain(eps[i], parameters.volume.strain_at_rest(now.pressure[i], K[i]), now.dt,
                                parameters.relaxation);
  }

 private:
  const CellLifeParameters &parameters;
};
}  // namespace turgor
