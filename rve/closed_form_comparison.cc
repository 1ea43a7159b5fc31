#include "rve/closed_form_comparison.h"

#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace turgor {
namespace {
const char *const component_names[2] = {"xx", "xy"};

Tensor2<2> deviator(const Tensor2<2> &s) { return s - 0.5 * s.trace() * Tensor2<2>::Identity(); }

/// What the cell has and the closed form has not. Where both act they may cancel: neither more nodes nor a
/// stiffer lamella need bring them together.
std::string why_off(const bool bending) {
  const std::string lamella = "more Cell/Nodes per side or a larger Cell/Lamella ratio makes its give less";
  return bending ? "The closed form has neither the give of the lamella (" + lamella +
                       ") nor the bending of the walls, which stays; Cell/Wall bending = false shows "
                       "the give alone."
                 : "The closed form has no give of the lamella: " + lamella + ".";
}
}  // namespace

ClosedFormComparison::ClosedFormComparison(const RveParameters &parameters)
    : rve(parameters),
      closed(parameters.yielding_cell()),
      square(parameters.structure.square() && parameters.structure.rotation == 0.) {}

ClosedFormComparison::Point ClosedFormComparison::add(const Tensor2<2> &F, const Tensor2<2> &stress,
                                                      const double pressure) {
  Point point;
  point.applies = square && closed.applies(F);
  if (!point.applies) return point;
  point.stress = closed.stress(F);
  point.pressure = closed.pressure(F);
  point.deviation = (deviator(stress) - deviator(point.stress)).cwiseAbs().maxCoeff();
  const double size = deviator(point.stress).cwiseAbs().maxCoeff(), floor = 0.005 * rve.cell.turgor;
  ++compared;
  for (int c = 0; c < 2; ++c) of_deviator[c].add(deviator(point.stress)(0, c), deviator(stress)(0, c));
  largest_deviation = std::max(largest_deviation, point.deviation);
  worst = std::max(worst, point.deviation / std::max(0.01 * size, floor));
  largest_pressure_deviation = std::max(largest_pressure_deviation, std::abs(pressure - point.pressure));
  return point;
}

void ClosedFormComparison::results(RunContext &context) const {
  context.result("points_with_closed_form", double(compared), "");
  if (compared > 0) {
    context.result("max_deviatoric_deviation", largest_deviation, "Pa");
    context.result("max_deviation_over_allowed", worst, "1");
    context.result("max_pressure_deviation", largest_pressure_deviation, "Pa");
    context.result("max_pressure_deviation_over_turgor", largest_pressure_deviation / rve.cell.turgor, "1");
    for (int c = 0; c < 2; ++c)
      if (of_deviator[c].exists()) {
        context.result(std::string("deviator_error_") + component_names[c], of_deviator[c].error(), "1");
        context.result(std::string("deviator_offset_over_turgor_") + component_names[c],
                       of_deviator[c].offset() / rve.cell.turgor, "1");
      }
  }
}

void ClosedFormComparison::remarks(RunContext &context) const {
  if (worst > 1.)
    remarked(context, "max_deviation_over_allowed",
             "the deviatoric stress is off that of flat walls by up to " + number_text(largest_deviation) +
                 " Pa, " + number_text(worst) +
                 " times the allowed 1 % of it or 0.5 % of turgor, whichever is more. " +
                 why_off(rve.cell.wall_bending));
  constexpr double noted = 0.05;  // of turgor
  if (largest_pressure_deviation > noted * rve.cell.turgor)
    remarked(context, "max_pressure_deviation_over_turgor",
             "the fluid's pressure is off that of flat walls by up to " +
                 number_text(largest_pressure_deviation, 3) + " Pa, " +
                 number_text(100. * largest_pressure_deviation / rve.cell.turgor, 3) + " % of turgor" +
                 (rve.fluid == RveFluid::hydrostatic
                      ? ": the middle lamella gives, and the little area this makes counts for a fluid that "
                        "is hardly compressible "
                        "(more Cell/Nodes per side or a larger Cell/Lamella ratio makes it less)."
                      : "."));
}

void ClosedFormComparison::say(RunContext &context) const {
  if (compared == 0) return;
  char line[200];
  std::snprintf(
      line, sizeof line,
      "largest deviatoric deviation from the flat-wall closed form %.4g kPa (%.2f of what is allowed)",
      1e-3 * largest_deviation, worst);
  context.say(line);
}
}  // namespace turgor
