// Scene `spheroid_deformable`: deformable cells that grow and divide, from one or a small clump to a spheroid
// (thesis 4.4.1, Fig. 4.6): their number, radius of gyration, pressure over time and over depth, the
// surfaces.
//
//   closed form   of the number of cells without inhibition, however they press on each other: the expected
//   number
//                 of descendants of newborn cells, or N_0 2^(t/T_d) for ages that are spread
//                 (laws/population_doubling.h)
//   books         energy stored = work of growth and division - heat - what steps of finite length lose
#pragma once

#include "micro/laws/first_phases.h"
#include "micro/scenes/deformable/cells_run.h"
#include "micro/scenes/deformable/growing_cells.h"
#include "run/scenario.h"

namespace turgor {
class SpheroidDeformable final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  GrowingCellsParameters parameters() const;
  std::vector<double> phases() const;
  std::vector<Vector<3>> places() const;  ///< m, of the first cells
  void report(RunContext &context, const GrowingCells &tissue, const std::vector<double> &row) const;

  TouchingMaterial material = [] {
    TouchingMaterial m;
    m.nu = 4;
    m.radius = 8.8e-6;
    m.bulk_modulus = 2500.;
    m.adhesion = 1e-5;
    m.viscosity = 600.;
    m.tolerance = 0.05;
    m.longest_step = 300.;
    m.range = 0.75e-6;
    return m;
  }();
  GrowthLaw growth = [] {
    GrowthLaw law;
    law.inhibition = Inhibition::none;
    return law;
  }();
  CellCycle cycle;
  CellDivision division = [] {
    CellDivision law;
    law.direction = DivisionDirection::random;
    return law;
  }();
  std::string axis = "0, 0, 1";
  unsigned int first_cells = 1, frames = 5, seed = 1;
  FirstPhases first_phases = FirstPhases::synchronous;
  double end = 5. * 86400., most_cells = 0., cycle_time = 86400., spread = 0.1;
  CellsOutput output;
};

std::unique_ptr<Scenario> make_spheroid_deformable();
}  // namespace turgor
