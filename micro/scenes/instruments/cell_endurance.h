// Scene `cell_endurance`: one periodic cell filled with SPH fluid, a million micro steps at
// F = I or at constant F_dot, and what should not change meanwhile.
//
//   pressure  against p(A) = p(rho_1 A_0/A) with the EOS of 2.22, where rho_1 is the density whose pressure
//             the fluid has at F = I: one rho_1 for the mean EOS pressure, one for the virial pressure
//   momentum  against the round-off that n particles collect in N steps
//   energy    potential + kinetic - work of the moving period = start - dissipated; the work is the integral
//             of (image part of the virial) : L dt, L = F_dot F^-1. Dissipated must be zero without viscosity
//             and never fall with it.
#pragma once

#include "micro/cells/sph_parenchyma.h"
#include "run/run_context.h"
#include "run/scenario.h"

#include <string>

namespace turgor {
class CellEndurance final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;  ///< endurance_run.h

  ParenchymaParameters cell;
  SphParameters sph;
  std::string F_dot = "0, 0; 0, 0";  ///< 1/s
  double steps = 1e6;
  double start_speed = 0.;  ///< m/s
  double step_fraction = 0.9;
  unsigned int samples = 1000, checkpoints = 10;
};

std::unique_ptr<Scenario> make_cell_endurance();
}  // namespace turgor
