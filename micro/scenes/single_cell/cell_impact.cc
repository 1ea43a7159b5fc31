// cell_impact: a plate comes down on a cell at impact speed; where it deforms, what force is transmitted,
// whether it oscillates. Thesis 3.3.3, Fig. 3.4.
#include "run/number_text.h"
#include "run/run_context.h"
#include "micro/scenes/single_cell/squeezed_cell.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
class CellImpact final : public SqueezedCell {
 public:
 protected:
  Outputs more_outputs() const override { return cell_impact_outputs(); }

  void report(RunContext &context, const Rows &rows) const override {
    result_at(context, rows, "force_upper", &Row::force_upper, "N");
    result_at(context, rows, "force_lower", &Row::force_lower, "N");
    result_at(context, rows, "height_share_upper", &Row::height_share, "1");
    result_at(context, rows, "contact_upper", &Row::contact_upper, "m");
    result_at(context, rows, "contact_lower", &Row::contact_lower, "m");
    result_at(context, rows, "mean_stretch_upper", &Row::mean_upper, "1");
    result_at(context, rows, "mean_stretch_lower", &Row::mean_lower, "1");
    for (const int percent : {5, 10, 15, 20, 25, 30, 40, 50})
      if (const double share = squeezed::upper_share(rows, 0.01 * percent - 1e-9); std::isfinite(share))
        context.result(
            std::string("deformation_share_upper_at_") + (percent < 10 ? "0" : "") + number_text(percent),
            share, "1");
    const squeezed::Swing swing = squeezed::transmitted_swing(rows);
    context.result("largest_force_lower", swing.largest, "N");
    context.result("force_lower_reversals", swing.reversals, "");
    context.result("force_lower_deepest_fall", swing.deepest_fall, "1");
    double most_upper = 1., most_lower = 1.;
    for (const Row &row : rows) {
      most_upper = std::max(most_upper, row.largest_upper);
      most_lower = std::max(most_lower, row.largest_lower);
    }
    context.result("largest_stretch_upper", most_upper, "1");
    context.result("largest_stretch_lower", most_lower, "1");
  }
};
}  // namespace

std::unique_ptr<Scenario> make_cell_impact() { return std::make_unique<CellImpact>(); }
}  // namespace turgor
