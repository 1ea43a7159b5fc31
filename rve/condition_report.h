// What rve_response tells of walls that flow, break or fail for good along a path (RveCondition of rve.h):
// the table condition.csv, when the first cell failed, and what was dissipated.
//
//   ConditionReport report(context);
//   report.add(time, answer);
//   report.results(context); report.say(context);
#pragma once

#include "rve/rve.h"

#include <memory>
#include <optional>

namespace turgor {
class RunContext;
class Outputs;
class Series;

class ConditionReport {
 public:
  explicit ConditionReport(RunContext &context);
  static void define(Outputs &outputs);

  void add(double time, const RveAnswer<2> &answer);
  void results(RunContext &context) const;
  void say(RunContext &context) const;

 private:
  struct Failure {
    double time;
    Tensor2<2> F;
  };
  std::unique_ptr<Series> table;
  std::optional<Failure> first;
  RveCondition last;
};
}  // namespace turgor
