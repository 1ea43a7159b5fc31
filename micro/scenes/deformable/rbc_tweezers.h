// Scene `rbc_tweezers`: a red blood cell pulled at two opposite ends by optical tweezers (thesis 4.3.1,
// Fig. 4.3; experiment: S. Suresh et al. 2005, 10.1016/j.actbio.2004.09.001).
//
// The cell is a biconcave disc of about 2500 nodes, free of stress as it is, with FENE edges (4.2, 4.3),
// hinges, area and content. At both ends of the x axis the outermost share of the nodes is pulled with one
// force a node, F in all. F rises to each of Forces in the Ramp time and is held for the Hold time; then the
// axial diameter (along x) and the transverse one (along y, in the plane of the disc) are measured, and
// compared with the experiment's range, point by point.
//
// Constants: bending rigidity and the ratio of area and shear moduli (1 and 49) as D. Fedosov, B. Caswell and
// G. Karniadakis 2010 (10.1016/j.bpj.2010.02.002); shear modulus 2.9 uN/m, the upper end of the 2.5 +- 0.4
// uN/m that S. Henon et al. 1999 (10.1016/S0006-3495(99)77279-6) measured with tweezers. That modulus and the
// largest stretch of an edge, 1.65, were chosen with these data in view, so that all points lie within their
// ranges: a fit, no prediction. With 2.5 uN/m 2 of 21 points lie outside, with Fedosov's 6.3 uN/m and 2.05
// half of them.
#pragma once

#include "micro/scenes/deformable/deformable_cell.h"
#include "run/scenario.h"

#include <string>
#include <vector>

namespace turgor {
class RbcTweezers final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  struct Measured  ///< a point of the experiment: newtons and metres; no range: low > high
  {
    double force = 0., mean[2] = {}, low[2] = {}, high[2] = {};
  };
  DeformableCellParameters<FeneSpring> cell() const;
  std::vector<Measured> experiment_points() const;  ///< of the file; throws InputError

  DeformableMaterial material{
      .nu = 16, .bulk_modulus = 1000., .viscosity = 1e-3, .tolerance = 1e-3, .longest_step = 0.1};
  double diameter = 7.82e-6, shear_modulus = 2.9e-6, largest_stretch = 1.65, rigidity = 2.4e-19;
  double local_area = 2.9e-6, whole_area = 1.4e-4;
  double cortex_viscosity = 6e-7;
  std::vector<double> forces{16e-12,  31e-12,  47e-12,  68e-12,  88e-12, 109e-12,
                             130e-12, 151e-12, 173e-12, 193e-12, 200e-12};
  double ramp = 1., hold = 1., pulled = 0.05;
  std::string experiment = "none";
  unsigned int samples = 200;
  bool fields = true;
};

std::unique_ptr<Scenario> make_rbc_tweezers();
}  // namespace turgor
