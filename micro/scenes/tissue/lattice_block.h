// A clamped block of cells whose fluid is at rest (hydrostatic_network.h), in equilibrium without and under a
// load (block_load.h):
//
//   min over x of E(x),  left side clamped,  density * b * width = load, dead forces of the traction
//
// Surfaces as in cut_block.h: frozen ones keep the reference; with free ones the block is relaxed without
// load at fixed mass first, with osmosis at the reference pressure of every cell, whose water then stays.
// Displacements are measured from there.
//
//   LatticeBlock block(cell, 16, 16, Surfaces::frozen);
//   block.relax(settings);
//   block.load({.size = 20e3}, settings);
//
// In and out: SI units.
#pragma once

#include "micro/cells/block_load.h"
#include "micro/cells/cut_block.h"
#include "micro/cells/network_equilibrium.h"

#include <functional>
#include <memory>

namespace turgor {
/// What one or several searches for equilibrium took.
struct LatticeEffort {
  int iterations = 0, factorisations = 0, increments = 0, escapes = 0;
  double residual = 0.;  ///< of the last one, see EquilibriumSettings
};

class LatticeBlock {
 public:
  /// Cells of any layout that is periodic both ways: as laid, and at turgor (turgid_layout.h).
  /// std::invalid_argument where they do not belong together.
  LatticeBlock(const CellLayout &laid, const CellLayout &turgid, Surfaces surfaces);
  /// A grid of square cells. std::invalid_argument for parameters outside their range.
  LatticeBlock(const ParenchymaParameters &cell, unsigned int columns, unsigned int rows, Surfaces surfaces);

  /// Without load: with free surfaces the cells bulge until they balance. RunFailed if they cannot.
  LatticeEffort relax(const EquilibriumSettings &settings);

  /// Under `load` from the relaxed state, in as many increments as Newton's method needs.
  /// after(share of the load reached) after each; RunFailed where no shorter increment helps.
  LatticeEffort load(const BlockLoad &load, const EquilibriumSettings &settings,
                     const std::function<void(double)> &after = {});

  Vector<2> probe_displacement() const;              ///< m, middle of the right side, from the relaxed state
  std::vector<Vector<2>> cell_displacement() const;  ///< m, centroids, from the relaxed state
  Vector<2> clamp_reaction() const;                  ///< N, of the slab's depth, that the clamp exerts
  const std::vector<double> &pressure() const {
    return equilibrium->last_evaluation().pressure;
  }                              ///< Pa per cell
  Vector<2> weight() const;      ///< N, body force on all fluid and walls
  Vector<2> dead_force() const;  ///< N, sum of the missing neighbours' forces and of the traction

  std::unique_ptr<HydrostaticNetwork> network;
  std::vector<std::uint32_t> clamped, probe;  ///< nodes
  std::vector<double> reference, relaxed,
      x;                           ///< m, node positions in the periodic grid, before and under the load
  std::vector<double> failed;      ///< m, where the last search that found nothing has ended
  double width;                    ///< m
  double density;                  ///< kg/m^3 of the reference
  Vector<2> acceleration{0., 0.};  ///< m/s^2, as loaded
  double reference_pressure = 0.;  ///< Pa

 private:
  LatticeBlock(const CutBlock &block, Surfaces surfaces);
  Vector<2> centroid(const std::vector<double> &at, std::size_t cell) const;

  Surfaces surfaces;
  void carry(const BlockLoad &load, double share);

  std::vector<double> dead;  ///< N a node and direction, of the missing neighbours
  std::vector<CutBlock::SideNode> right;
  Vector<2> on_right{0., 0.};  ///< N, of the traction that is on
  std::unique_ptr<NetworkEquilibrium> equilibrium;
};
}  // namespace turgor
