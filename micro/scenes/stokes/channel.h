// Scenes `poiseuille` and `couette`: a Stokes fluid of SPH particles between two flat plates (thesis 2.3.1:
// "has been shown to reproduce ... Poiseuille flow, Couette flow"), periodic along them, against the closed
// forms of reference/channel_flow.h: the profile of the velocity and the plates' drag, steady or, with
// inertia, from the start.
//
// Lower plate at y = 0, at rest; upper plate at y = H. poiseuille: a body force along x by which the parabola
// reaches Speed in the middle. couette: the upper plate moves at Speed.
#pragma once

#include "micro/scenes/stokes/stokes_course.h"
#include "micro/scenes/stokes/stokes_flow.h"
#include "run/scenario.h"

namespace turgor {
class Channel : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 protected:
  explicit Channel(bool dragged_) : dragged(dragged_) {}

 private:
  class Run;
  double exact(double y, double t) const;     ///< m/s
  double exact_lower_stress(double t) const;  ///< Pa, what the fluid drags the lower plate along x with
  double spacing() const { return height / across; }

  bool dragged;  ///< by the upper plate
  StokesFlowParameters flow;
  StokesCourse course{.end = 0.04};
  double height = 20e-6, speed = 1e-3;
  unsigned int across = 20, along = 20;
};

std::unique_ptr<Scenario> make_poiseuille();
std::unique_ptr<Scenario> make_couette();
}  // namespace turgor
