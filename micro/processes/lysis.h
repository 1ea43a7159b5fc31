// Dead cells drain until the solid part is left (cell_death.h); the remains of those that have done so are
// taken away where that is asked for. Columns of a cell: strain (none), bulk_modulus (Pa), with necrosis
// volume_at_death (m^3). Of a sphere: reference_volume (m^3).
#pragma once

#include "micro/processes/cell_life_parameters.h"
#include "micro/processes/process.h"

namespace turgor {
class Lysis final : public Process {
 public:
  explicit Lysis(const CellLifeParameters &parameters_) : parameters(parameters_) {}
  void declare(Particles<3> &particles) const override {
    if (parameters.death.rim == Rim::necrotic) particles.cells.declare("volume_at_death");
  }
  void change(Interval &now) override;
  void rearrange(Interval &now) override;

 private:
  const CellLifeParameters &parameters;
};
}  // namespace turgor
