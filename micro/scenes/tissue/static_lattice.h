// Scene `static_lattice`: the static state of a clamped block of cells whose fluid is at rest
// (one pressure per cell). Every wall of every cell is there, and no dynamics: what full_micro swings
// about, at the cost of a few sparse factorisations. Measures the surface effect and the error of
// homogenisation against the static state of FE^2 (tissue_statics).
//
//   min over x of E(x) of hydrostatic_network.h, left side clamped, under Load and Traction (block_load.h)
//
// Surfaces, as in cut_block.h:
//   frozen   the reference forces of the missing neighbours stay as dead forces
//   free     relaxed without load at fixed mass first; displacements are measured from there
//   osmosis  as free, but relaxed at the reference pressure of every cell; the water then stays
//   slab     periodic in y, frozen at the right side
//
// In: SI units. Out: displacement of the middle of the right side (m), cell_displacement.csv (centroids, m).
#pragma once

#include "micro/cells/tissue_structure.h"
#include "micro/scenes/tissue/lattice_block.h"
#include "run/run_context.h"
#include "run/scenario.h"

#include <memory>
#include <string>

namespace turgor {
class StaticLattice final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  static struct FieldFrame frame_of(const LatticeBlock &block, const std::vector<double> &x,
                                    double share_of_load);
  void write_cells(RunContext &context, const LatticeBlock &block) const;

  LatticeBlock make_block() const;

  ParenchymaParameters cell;
  TissueStructure structure;
  unsigned int columns = 16, rows = 16;
  BlockLoad load;
  Surfaces surfaces = Surfaces::frozen;
  EquilibriumSettings equilibrium;
  bool fields = true;
};

std::unique_ptr<Scenario> make_static_lattice();
}  // namespace turgor
