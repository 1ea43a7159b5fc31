// Scene `spheroid_capsule`: a spheroid grows against an elastic capsule (experiment I, thesis 5.2, 5.4.2;
// Fig. 5.5, 5.6, C.2).
//
// Defaults: CT26 in the thin capsule, Model I; contacts of a closest packing until a calibration exists
// (errata, C.9).
//
// Confluence, t = 0, is when the spheroid's edge comes within 1 % of the capsule's radius at rest. From then
// on
//   24 h, 48 h   the capsule's pressure; that after a day is what the thesis calls the transition (C.2.2)
//   transition   the straight lines of the fastest 12 h and of the residual growth cross: time, and the
//                capsule's pressure then, 0.2 to 0.3 kPa lower by construction
//   residual     slope of the capsule's radius from 48 h (runs shorter than 72 h: their last third) to the
//                end
//   density      cells per 100 um^2 of a section of 10 um, at confluence and 48 h later
#pragma once

#include "micro/scenes/spheroid/spheroid_scene.h"
#include "micro/terms/elastic_capsule.h"

namespace turgor {
class SpheroidCapsule : public SpheroidScene {
 public:
  SpheroidCapsule();

 protected:
  Outputs more_outputs() const override;
  void declare_more(InputEntries &prm) override;
  void check_more() const override;
  Surroundings make_surroundings() const override;
  bool finished(const GrowthTable &table) const override;
  double share_until_finished(const GrowthTable &table) const override;
  void report(RunContext &context, const GrowthTable &table, CellCulture &culture) const override;

 private:
  /// s; negative: not yet confluent.
  double confluence(const GrowthTable &table) const;

  CapsuleParameters capsule;
  double capsule_poisson = 0.5;
  double wall_friction = 2e10;    ///< N s/m^3
  double confined = 48. * 3600.;  ///< s, after confluence
};

std::unique_ptr<Scenario> make_spheroid_capsule();
}  // namespace turgor
