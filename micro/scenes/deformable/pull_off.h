// Scene `pull_off`: a deformable cell comes to rest on an adhesive plane or on another cell, then is drawn
// off by a spring on its centre that moves slowly: force against displacement, its maximum over pi W R* (R*:
// R on a plane, R/2 of two cells) beside the lines of JKR (3/2), DMT (2) and of a vesicle (1), and the same
// of a shell of revolution (reference/axial_shell.h), of which two cells are mirror images.
#pragma once

#include "micro/scenes/deformable/cells_run.h"
#include "run/choice.h"
#include "run/scenario.h"

namespace turgor {
enum class PulledFrom { plane, cell };
constexpr const char *words_of(PulledFrom) { return "plane|cell"; }

class PullOff final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  double effective_radius() const {
    return from == PulledFrom::cell ? 0.5 * material.radius : material.radius;
  }
  /// Result axial_pull_off (N), where a shell of revolution finds its way.
  void compare(RunContext &context, double pull_off) const;

  TouchingMaterial material = [] {
    TouchingMaterial m;
    m.bulk_modulus = 2500.;
    m.tolerance = 0.05;
    m.adhesion = 1e-5;
    m.range = 0.75e-6;
    m.friction = 1e6;
    m.longest_step = 20.;
    return m;
  }();
  PulledFrom from = PulledFrom::plane;
  double settling = 1e4, first_step = 1e-3, speed = 2.5e-10, way = 5e-6, stiffness = 0.01;
  unsigned int seed = 1;
  CellsOutput output;
};

std::unique_ptr<Scenario> make_pull_off();
}  // namespace turgor
