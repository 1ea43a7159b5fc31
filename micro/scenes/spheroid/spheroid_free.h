// Scene `spheroid_free`: a spheroid from a few cells in free suspension (thesis 5.4.2, C.2.1).
//
//   doubling time    from the slope of log N over the last whole cycles, against its closed form: cells whose
//                    cycle times are Gaussian, T (1 + s xi), grow as N ~ exp(Lambda t) with 2 <exp(-Lambda
//                    T_i)> = 1, so Lambda T = (1 - sqrt(1 - 2 s^2 ln 2))/s^2
//   exponential      largest deviation of N from that line in that time, over N: synchronous first cells make
//                    steps
//   rim              with a rim of thickness l, growth at its own rate ln 2/T: dR/dt = l ln 2/T (1 - l/R +
//                    l^2/(3 R^2)). It is of a smooth ball whose fill does not change; the slope of R over the
//                    second half is compared with it at the middle R of that time, and with its mean over
//                    that time. Production: the volume made in that time over ln 2/T times the integral of
//                    the volume of the proliferating cells, which shape and fill do not touch
#pragma once

#include "micro/laws/population_doubling.h"
#include "micro/scenes/spheroid/body_entries.h"
#include "micro/scenes/spheroid/spheroid_scene.h"

namespace turgor {
class SpheroidFree : public SpheroidScene {
 public:
  SpheroidFree();

 protected:
  void declare_more(InputEntries &prm) override {
    if (takes_body) body.declare(prm);
  }
  void check_more() const override;
  Surroundings make_surroundings() const override;
  bool has_body() const override { return body.is_there(); }
  Outputs more_outputs() const override;
  void report(RunContext &context, const GrowthTable &table, CellCulture &culture) const override;

  bool takes_body = true;  ///< whether it has the subsection Body

 private:
  void report_body(RunContext &context, const GrowthTable &table) const;

  BodyEntries body;
};

std::unique_ptr<Scenario> make_spheroid_free();
}  // namespace turgor
