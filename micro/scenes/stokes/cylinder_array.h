// Scene `cylinder_array`: a Stokes fluid of SPH particles (thesis 2.3.1) that a body force drives through a
// square array of cylinders, one period of it, against the exact drag (reference/cylinder_array.h).
//
// A force b (m/s^2) along x acts on the fluid as a mean gradient rho b of pressure does, so that with the
// period L and the superficial speed U, the mean velocity over all of the period, the drag is rho b L^2/(mu
// U) over viscosity and speed.
#pragma once

#include "micro/scenes/stokes/stokes_course.h"
#include "run/scenario.h"

namespace turgor {
class CylinderArray final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  double spacing() const { return period / across; }
  double radius() const;  ///< m

  StokesFlowParameters flow;
  StokesCourse course{.end = 0.1, .samples = 20, .frames = 1};
  double period = 20e-6, porosity = 0.8, speed = 1e-5, gap = 0.05;
  unsigned int across = 30;
};

std::unique_ptr<Scenario> make_cylinder_array();
}  // namespace turgor
