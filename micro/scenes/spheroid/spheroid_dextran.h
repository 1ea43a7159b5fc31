// Scene `spheroid_dextran`: a spheroid under the osmotic pressure of a dextran solution (experiment II,
// thesis 5.2, 5.4.2; Fig. 5.1).
//
// Rim = quiescent with 30 um (Model II). Cell lines differ in their cycle time, fitted to growth without
// dextran (errata: 5.4.2 before Table C.2): CT26 17 h, AB6 13 h, HT29 46 h, BC52 31 h, FHI 20 h. BC52 and FHI
// have two regimes: after 9 days the rim is 0.7 and 0.35 of what it was. Pressure 0 is the control. Reported:
// slope of the radius over the whole time after the first day, and in both regimes; mean pressure of the
// cells; at the end the pressure over the depth below the edge in shells of a cell's diameter (profile.csv):
// of the outermost shell, and within half the radius.
#pragma once

#include "micro/scenes/spheroid/spheroid_scene.h"

namespace turgor {
class SpheroidDextran : public SpheroidScene {
 public:
  SpheroidDextran();

 protected:
  Outputs more_outputs() const override;
  void declare_more(InputEntries &prm) override;
  Surroundings make_surroundings() const override;
  CultureParameters culture_parameters() const override;
  void before_interval(CellCulture &culture) const override;
  void report(RunContext &context, const GrowthTable &table, CellCulture &culture) const override;

 private:
  /// profile.csv and the pressure at the rim and in the core, at the end.
  void report_profile(RunContext &context, CellCulture &culture) const;
  struct Line {
    double cycle_time, rim_factor;
  };
  Line line() const;

  std::string cell_line = "CT26";
  double pressure = 5e3;  ///< Pa
  bool fixed_force = false;
  double rise = 7200.;                 ///< s
  double regime_change = 9. * 86400.;  ///< s
};

std::unique_ptr<Scenario> make_spheroid_dextran();
}  // namespace turgor
