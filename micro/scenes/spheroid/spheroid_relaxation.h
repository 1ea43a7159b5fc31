// Scene `spheroid_relaxation`: a compressed spheroid let go (thesis C.2.1), by which the friction of the
// cells is calibrated: T_rel of 2 h, and of 5 h.
//
// A cluster settles without growth; then it is made smaller to a share of its size and held until the cells'
// volumes are at rest under their pressures; at t = 0 it is let go. Observed: the radius of gyration, R_g =
// sqrt(5/3 <r^2>). Relaxation time: when (R_end - R_g)/(R_end - R_g(0)) = 1/e. Cells recover their volume
// with their own T_rel (C.3) and push each other apart against friction; which of the two is slower decides.
#pragma once

#include "micro/scenes/spheroid/spheroid_scene.h"

namespace turgor {
class SpheroidRelaxation final : public SpheroidScene {
 public:
  SpheroidRelaxation();

 protected:
  Outputs more_outputs() const override;
  void declare_more(InputEntries &prm) override;
  void check_more() const override;
  CultureParameters culture_parameters() const override;
  void seed(CellCulture &culture) const override;
  void report(RunContext &context, const GrowthTable &table, CellCulture &culture) const override;

 private:
  double size = 0.9;              ///< of the compressed spheroid over the settled one
  double settling = 24. * 3600.;  ///< s
};

std::unique_ptr<Scenario> make_spheroid_relaxation();
}  // namespace turgor
