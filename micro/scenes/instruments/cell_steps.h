// Scene `cell_steps`: how long the steps of an over-damped population may be. A ball of cells, disturbed,
// relaxes for a given time: with fixed steps of each method, halved from the whole time on, and with adaptive
// ones. Errors are against adaptive second-order steps of a tight tolerance: root mean square of the
// positions over the radius.
//
// Disturbances: cells replaced by newborn pairs close together, compression of the ball's volume, stiffer
// contacts, less friction. A fixed step is called stable where the run ends with an error below a tenth of a
// radius. A run that cannot go on counts with its sentence.
//
//   steps.csv   method, adaptive or not, step (s) or tolerance, error, CPU time, steps, stable
#pragma once

#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/terms/sphere_contacts.h"
#include "run/run_context.h"
#include "run/scenario.h"

namespace turgor {
class CellSteps : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  struct Outcome {
    Particles<3> cells;
    double cpu = 0.;  ///< s
    std::uint64_t steps = 0;
    bool ended = false;
    std::string sentence;  ///< where it did not
  };
  Particles<3> start() const;
  Outcome relax(OverdampedMethod method, double tolerance, double step, RunContext &context) const;
  double error(const Outcome &outcome, const Outcome &reference) const;

  unsigned int count = 150, halvings = 12;
  double duration = 3600., newborn = 0., compression = 1., stiffer = 1., less_friction = 1.;
  double radius = 7e-6, modulus = 590., pair_friction = 5e10, medium_friction = 5e8, tightest = 1e-5;
};

std::unique_ptr<Scenario> make_cell_steps();
}  // namespace turgor
