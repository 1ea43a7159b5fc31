#include "micro/scenes/tissue/tissue_loading.h"

#include "micro/cells/parenchyma_remarks.h"
#include "micro/cells/sph_cell_entries.h"
#include "micro/engine/step_control.h"
#include "run/entry_marks.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "micro/scenes/shared_entries.h"
#include "micro/scenes/tissue/tissue_run.h"

#include <algorithm>

namespace turgor {
TissueLoading::TissueLoading(const TissueLoadingDefaults &defaults)
    : text(defaults.description),
      speed(defaults.speed),
      end_strain(defaults.end_strain),
      damping(defaults.damping) {
  brick.critical_stretch = defaults.critical_stretch;
  brick.lamella_strength = defaults.lamella_strength;
  cell.nodes_per_side = 16;
  sph.particles_per_side = 12;
}

void TissueLoading::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  brick.add_parameters(prm);
  prm.add_parameter("Speed", speed, "Speed of the upper plate, which moves down. Units: m/s.",
                    Double(1e-4, 100.));
  prm.add_parameter(
      "End strain", end_strain,
      "Way of the upper plate at the end of the run, over the height of the inflated tissue. Units: none.",
      Double(1e-4, 0.9));
  prm.add_parameter("Damping", damping,
                    "Rate at which all velocities decay while the plate moves: for quasi-static loading; 0: "
                    "none. Units: 1/s.",
                    Double(0., 1e9));
  declare_step_fraction(prm, step_fraction);
  declare_substeps(prm, substeps);
  prm.add_parameter("Samples", samples,
                    "Number of equal parts of the plate's way after each of which loading.csv and rows.csv "
                    "get a row. Units: none.",
                    Integer(10, 1000000));
  prm.add_parameter("Frames", frames,
                    free_to_change("Number of equal parts of the plate's way after each of which the "
                                   "particles are written for ParaView and pictures; 0: never. Units: none."),
                    Integer(0, 100000));
  declare_checkpoints(prm, checkpoints);
  declare_sph_cell(prm, cell, sph);
}

void TissueLoading::check() const {
  check_sph_cell(cell, sph);
  check_substeps(substeps, sph);
  brick.check(cell, sph);
  if (brick.sides == TissueSides::widening && substeps > 1)
    throw InputError("Substeps is " + number_text(substeps) +
                     ", but Sides = widening moves the particles between steps: use Substeps = 1.");
  require_few_steps(first_step());
}

double TissueLoading::first_step() const {
  BrickParameters few = brick;  // the step is that of a cell
  few.columns = std::min(brick.columns, 2u);
  few.rows = std::min(brick.rows, 2u);
  const auto tissue = make_brick_tissue(cell, sph, few);
  return StepControl<2>(tissue->system, step_fraction, spacings_a_step).dt();
}

double TissueLoading::expected_cpu() const {
  constexpr double of_a_particle = 2.5e-7, inflating = 6000.;  // s; steps
  const double particles =
      double(brick.columns) * brick.rows *
      (double(sph.particles_per_side) * sph.particles_per_side + 4. * cell.nodes_per_side);
  return particles * of_a_particle *
         (inflating + end_strain * brick.rows * cell.period / speed / first_step());
}

void TissueLoading::require_few_steps(const double dt) const {
  constexpr double most = 2e9;
  if (const double steps = end_strain * brick.rows * cell.period / speed / dt; steps > most)
    throw InputError("Speed is " + number_text(speed) + " m/s: the run would take " + number_text(steps) +
                     " steps, allowed are " + number_text(most) +
                     ". Choose a larger Speed or a smaller End strain.");
}

void TissueLoading::run(RunContext &context) {
  remark_on_walls(context, cell);
  Run(*this, context).go();
}

std::unique_ptr<Scenario> make_tissue_compression() {
  return std::make_unique<TissueLoading>(
      TissueLoadingDefaults{.description = "Aggregate of turgid cells squeezed slowly between two plates: "
                                           "stress against strain, dense or sparse.",
                            .speed = 0.25,
                            .damping = 2e4});
}

std::unique_ptr<Scenario> make_tissue_impact() {
  return std::make_unique<TissueLoading>(
      TissueLoadingDefaults{.description = "Aggregate of turgid cells hit by a plate at 5 m/s: where it "
                                           "deforms, what reaches the other side."});
}

std::unique_ptr<Scenario> make_tissue_failure() {
  return std::make_unique<TissueLoading>(TissueLoadingDefaults{
      .description =
          "Impact on an aggregate whose walls and lamella break: which cells fail, when and how deep.",
      .end_strain = 0.5,
      .critical_stretch = 1.1,
      .lamella_strength = 4e6});
}
}  // namespace turgor
