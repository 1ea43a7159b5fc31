// Scenario rve_response: the stress of one RVE along a loading path (loading_path.h: every component of F or
// of P given), or at one F given by hand, beside the flat-wall closed form; its tangents along the path
// (tangent_report.h) and what happens to its walls (condition_report.h). Writes stress.csv.
#pragma once

#include "run/scenario.h"
#include "rve/loading_path.h"
#include "rve/rve.h"
#include "rve/rve_parameters.h"

namespace turgor {
class RveResponse : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  struct Walk;
  /// One answer after the other along the path. Throws RunFailed where there is no stress; what was found
  /// before has been written.
  void walk(RunContext &context, Walk &walk) const;
  /// What was found at a point, into tables and results.
  void take(Walk &walk, const LoadingPath::Load &load, const RveAnswer<2> &found,
            bool with_tangent = true) const;
  /// What was found since the last call, on the way to a point, into the balance of energy.
  void account(Walk &walk, const RveAnswer<2> &found, double time, double since) const;
  void add_row(Walk &walk, const LoadingPath::Load &load) const;
  void finish(RunContext &context, const Walk &walk) const;
  /// rve, with the Gap that opens Structure/Void fraction where one is wanted.
  RveParameters opened(RunContext &context) const;

  RveParameters rve;
  LoadingEntries loading;
  bool tangents = true;
  double void_fraction = 0.;  ///< 0: the gap counts
};

std::unique_ptr<Scenario> make_rve_response();
}  // namespace turgor
