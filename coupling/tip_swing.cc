#include "coupling/tip_swing.h"

#include "coupling/tissue_output.h"
#include "run/archive.h"

namespace turgor {
void TipSwing::open(RunContext &context, const Tissue<2> &tissue) {
  const auto &size = tissue.size();
  tip = tissue.probe({dealii::Point<2>(size[0], 0.5 * size[1])});
  probe_series = context.series("probe", {{"time", "s"}, {"displacement_x", "m"}, {"displacement_y", "m"}});
}

void TipSwing::row(const Tissue<2> &tissue, const RveLaw<2> &) {
  const dealii::Tensor<1, 2> u = tissue.displacement_at(tip).front();
  probe_series->add_row({tissue.time(), u[0], u[1]});
  swing.add(tissue.time(), u * along);
}

void TipSwing::results(RunContext &context, const Tissue<2> &tissue, const RveLaw<2> &) {
  write_cell_displacement(context, tissue, cells, cell_size, samples);
  const dealii::Tensor<1, 2> u = tissue.displacement_at(tip).front();
  context.result("tip_displacement_x", u[0], "m");
  context.result("tip_displacement_y", u[1], "m");
  context.result("tip_largest_deflection", swing.maximum().value, "m");
  if (swing.has_maximum()) {
    context.result("time_of_largest_deflection", swing.maximum().time, "s");
    // A damped swing is at its maximum after half a period; the return is the better measure where it was
    // reached.
    context.result("period_from_maximum", 2. * swing.maximum().time, "s");
  }
  if (swing.has_return()) {
    context.result("period_from_return", swing.minimum().time, "s");
    context.result("tip_deflection_at_return", swing.minimum().value, "m");
  }
}

void TipSwing::archive(Archive &a) {
  a.section("tip swing");
  a(swing);
}

std::vector<std::array<double, 2>> TipSwing::places() const {
  // Where bending shows most first: at the clamp, above and below, then the free end.
  return {{{0.03, 0.97}}, {{0.97, 0.50}}, {{0.03, 0.03}}, {{0.50, 0.97}}, {{0.03, 0.50}},
          {{0.50, 0.03}}, {{0.97, 0.97}}, {{0.97, 0.03}}, {{0.50, 0.50}}};
}
}  // namespace turgor
