// Scene texture_test: a compression or puncture test of plant tissue as a texture analyser makes it. A block
// [0, Width] x [0, Height], clamped at x = 0 or on a plate there, is pressed at x = Width by a plate or a
// cylinder at 1 mm/s: force over travel, bio-yield, failed cells. Quasi-static FE^2: load steps of its own
// choice (coupling/static_run.h), not the 1e-9 s of explicit ones. Units SI, per metre of depth.
#pragma once

#include "coupling/static_run.h"
#include "run/scenario.h"
#include "rve/rve_parameters.h"

namespace turgor {
class TextureTest : public Scenario {
 public:
  TextureTest();
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  bool uses_ranks() const override { return true; }
  void run(RunContext &context) override;

 private:
  StaticRunSettings settings;
  RveParameters rve_parameters;
};

std::unique_ptr<Scenario> make_texture_test();
}  // namespace turgor
