// Scene tissue_statics: the static state of the piece of tissue_gravity by FE^2. A block of cells x
// cells_across parenchyma cells, W = cells times their length, clamped at x = 0, under a body force b in -y:
//
//   Div P(F) + rho b = 0,  rho b W = load,   P of a hydrostatic RVE in elastic equilibrium (thesis Eq. 3.21)
//
// by Newton's method with the RVEs' analytic tangents (static_equilibrium.h). FE^2 knows no cell size: tip/W
// depends on the mesh only. Against static_lattice it gives the error of homogenisation. Units SI.
#pragma once

#include "macro/static_equilibrium.h"
#include "macro/tissue_parameters.h"
#include "run/scenario.h"
#include "rve/rve_parameters.h"

namespace turgor {
class TissueStatics : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  bool uses_ranks() const override { return true; }
  void run(RunContext &context) override;

 private:
  TissueParameters<2> tissue;
  StaticSettings newton;
  RveParameters rve_parameters;
  double load = 20e3;  ///< Pa
  unsigned int cells = 16, elements = 8, cell_samples = 5;
  unsigned int cells_across = 0, elements_across = 0;  ///< 0: as along the length

  std::array<unsigned int, 2> block() const;  ///< cells in x and y
  TissueParameters<2> piece(const std::array<double, 2> &cell) const;
};

std::unique_ptr<Scenario> make_tissue_statics();
}  // namespace turgor
