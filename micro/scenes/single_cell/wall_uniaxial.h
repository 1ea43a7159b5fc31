// Scene `wall_uniaxial`: a wall pulled, for several A and B of the yielding law (thesis Eq. 3.8, Fig. 3.3C).
// A ring of wall bonds, without fluid or bending, is widened: all bonds have the same stretch, and every node
// is pulled inwards by 2 T sin(pi/n), from which the tension T that the wall term really makes is measured.
// Compared with Eqs. 3.4, 3.5 and 3.8 (corrected), written out here a second time.
#pragma once

#include "run/scenario.h"

#include <memory>
#include <string>
#include <vector>

namespace turgor {
class WallUniaxial final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  double wall_stiffness = 100., depth = 50e-6, beta = 0.5;
  std::vector<double> sharpness{15., 5., 50.}, drop{0., 0.5, 0.9};
  double largest_stretch = 1.3;
  unsigned int points = 60;
  bool plastic = true;  ///< on the way back; else along the same curve
};

std::unique_ptr<Scenario> make_wall_uniaxial();
}  // namespace turgor
