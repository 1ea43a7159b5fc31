// Scene `rotating_block`: a free block of a viscoelastic solid is stretched homogeneously and then turned as
// a rigid body, by full turns: what becomes of its stress? Jaumann's rate by an exact rotation (thesis
// Eq. 2.33, 2.34, laws/hencky_solid.h) turns it with the block and changes nothing else.
//
//   every particle's stress at the angle a:   R(a) S R(a)',   S = 2 G dev(ln U) of the whole stretch U
//
// The motion is given; what is tested is what the particles make of it: their lists, gradients and stresses.
#pragma once

#include "micro/scenes/stokes/solid_entries.h"
#include "run/scenario.h"

namespace turgor {
class RotatingBlock final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  SolidParameters solid;
  double side = 200e-6, along = 1.1, across = 0.95, disorder = 0.2;
  unsigned int particles = 20, seed = 1, stretching = 20, steps = 360, turns = 1, frames = 8;
};

std::unique_ptr<Scenario> make_rotating_block();
}  // namespace turgor
