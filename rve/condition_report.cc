#include "rve/condition_report.h"

#include "micro/geometry/tensor_text.h"
#include "run/number_text.h"
#include "run/output_list.h"
#include "run/run_context.h"

namespace turgor {
namespace {
const char *const lasting = "with walls that flow (Wall/Yielding = plastic) or break (Wall/Critical stretch)";
}

ConditionReport::ConditionReport(RunContext &context)
    : table(context.series("condition", {{"time", "s"},
                                         {"failed_share", "1"},
                                         {"permanent_stretch", "1"},
                                         {"flow_dissipation", "J/m^3"},
                                         {"failure_dissipation", "J/m^3"},
                                         {"torn_dissipation", "J/m^3"}})) {}

void ConditionReport::define(Outputs &outputs) {
  outputs
      .results({{"failed_share", "1", "Share of the cells that have failed at the last point.", lasting},
                {"permanent_stretch", "1",
                 "Mean permanent stretch of the walls at the last point over that at rest, less 1.", lasting},
                {"first_failure_time", "s", "Time of the first point at which a cell had failed.",
                 "where a cell failed"}})
      .table(
          "condition", "One row for each point of the path at which the stress is found.",
          {{"time", "s", "Time on the path of deformation.", lasting},
           {"failed_share", "1", "Share of the cells that have failed.", lasting},
           {"permanent_stretch", "1", "Mean permanent stretch of the walls over that at rest, less 1.",
            lasting},
           {"flow_dissipation", "J/m^3", "Energy over undeformed volume that yielding walls have taken.",
            lasting},
           {"failure_dissipation", "J/m^3", "Energy over undeformed volume set free by walls that broke.",
            lasting},
           {"torn_dissipation", "J/m^3",
            "Energy over undeformed volume that failed cells have lost after that: by fluid that leaks out "
            "and by torn walls that drag holds.",
            lasting}});
}

void ConditionReport::add(const double time, const RveAnswer<2> &answer) {
  last = answer.condition;
  table->add_row({time, last.failed, last.permanent, last.flow_dissipated, last.failure_dissipated,
                  last.torn_dissipated});
  if (!first && last.failed > 0.) first = {time, answer.trial.F};
}

void ConditionReport::results(RunContext &context) const {
  context.result("failed_share", last.failed, "1");
  context.result("permanent_stretch", last.permanent, "1");
  if (first) context.result("first_failure_time", first->time, "s");
}

void ConditionReport::say(RunContext &context) const {
  if (first)
    context.say("The first cell failed by time " + number_text(first->time) +
                " s, F = " + tensor_text(first->F, 4) + "; " + number_text(100. * last.failed, 3) +
                " % of the cells have failed at the end");
}
}  // namespace turgor
