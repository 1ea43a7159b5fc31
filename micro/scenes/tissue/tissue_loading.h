// An aggregate of cells (brick_tissue.h) between two rigid plates: inflated to turgor by osmosis, then
// squeezed by the upper plate, which moves down at a given speed (thesis 3.3.2, 3.3.3). The lower plate
// stays. What the scenes tissue_compression, tissue_impact and tissue_failure share; they differ in their
// defaults.
//
// Strain is the way of the upper plate over the height of the inflated tissue, stress is force over (width of
// the inflated tissue x depth). Plates are frictionless, the sides are free. Water does not flow while the
// plates move.
#pragma once

#include "micro/cells/brick_tissue.h"
#include "run/run_context.h"
#include "run/scenario.h"
#include "micro/terms/obstacles.h"

#include <memory>
#include <string>

namespace turgor {
struct TissueLoadingDefaults {
  std::string description;
  double speed = 5.;  ///< m/s
  double end_strain = 0.3;
  double damping = 0.;  ///< 1/s
  double critical_stretch = 0.;
  double lamella_strength = 0.;  ///< Pa
};

class TissueLoading final : public Scenario {
 public:
  explicit TissueLoading(const TissueLoadingDefaults &defaults);

  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

  /// s of CPU time that a run takes, within a factor of two: steps of the tissue as it is laid, and what one
  /// of a particle has cost.
  double expected_cpu() const;

 private:
  class Run;  ///< one run: the tissue, its plates, its history

  static constexpr double spacings_a_step = 0.02;  ///< of StepControl
  double first_step() const;                       ///< s, of few cells as they are laid
  /// dt: s; throws InputError.
  void require_few_steps(double dt) const;

  std::string text;
  ParenchymaParameters cell;
  SphParameters sph;
  BrickParameters brick;
  double speed, end_strain, damping;
  double step_fraction = 0.8;
  unsigned int substeps = 1;
  unsigned int samples = 400, frames = 6, checkpoints = 10;
};

std::unique_ptr<Scenario> make_tissue_compression();
std::unique_ptr<Scenario> make_tissue_impact();
std::unique_ptr<Scenario> make_tissue_failure();
}  // namespace turgor
