// cell_failure: a cell squeezed slowly or struck until its wall breaks: where the crack starts and at what
// deformation, and where the balloon model (3D, slow) has its largest stretch when that reaches lambda_c.
// Thesis 3.3.3, Fig. 3.5A, B.
#include "run/run_context.h"
#include "micro/scenes/reference/cell_balloon.h"
#include "micro/scenes/single_cell/squeezed_cell.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
class CellFailure final : public SqueezedCell {
 public:
  CellFailure() {
    critical_stretch =
        1.2;  // where a slow crack starts at the equator; at 1.04 it is the edge of the contact (errata)
    deformation = 0.56;
  }

  void check() const override {
    SqueezedCell::check();
    if (critical_stretch == 0.)
      throw InputError(
          "Critical stretch is 0, but cell_failure needs one above 1 (cell_impact and cell_compression do "
          "without).");
    if (cell.fluid == CellFilling::pressure)
      throw InputError(
          "Cell/Fluid is pressure, but an opened cell does not have one pressure; use sph or none.");
  }

 protected:
  Outputs more_outputs() const override { return cell_failure_outputs(); }

  void report(RunContext &context, const Rows &rows) const override {
    double upper = 0., lower = 0.;
    for (const Row &row : rows) {
      upper = std::max(upper, row.force_upper);
      lower = std::max(lower, row.force_lower);
    }
    context.result("largest_force_upper", upper, "N");
    context.result("largest_force_lower", lower, "N");
    if (dimension != 3 || !(start_pressure > 0.)) return;
    try {
      BalloonModel balloon = balloon_of(cell, rest_radius, start_pressure, BalloonModel::Membrane::net);
      balloon.elements = 200;
      const auto first = BalloonModel::first_break(balloon.compress(deformation), critical_stretch);
      if (!std::isfinite(first.deformation)) return;
      context.result("balloon_break_deformation", first.deformation, "1");
      context.result("balloon_break_angle", first.angle, "degrees");
      context.result("balloon_break_tilt", first.direction == 1 ? 0. : 90., "degrees");
      if (first_deformation > 0.)
        context.result("break_deformation_over_balloon", 100. * (first_deformation / first.deformation - 1.),
                       "%");
    } catch (const RunStopped &) {
      throw;
    } catch (const RunFailed &)  // a result that is no number
    {
      throw;
    } catch (const std::runtime_error &error) {
      context.note("balloon_model", error.what());
    }
  }
};
}  // namespace

std::unique_ptr<Scenario> make_cell_failure() { return std::make_unique<CellFailure>(); }
}  // namespace turgor
