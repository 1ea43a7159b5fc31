// Scene `static_lattice`: the static state of a clamped block of cells whose fluid is at rest
// (one pressure per cell). Every wall of every cell is there, and no dynamics: what full_micro swings
// about, at the cost of a few sparse factorisations. Measures the surface effect and the error of
// homogenisation against the static state of FE^2 (tissue_statics).
//
//   min over x of E(x) of hydrostatic_network.h, left side clamped, body acceleration b in -y,
//   density * b * width = Load
//
// Surfaces, as in tissue_block.h:
//   frozen   the reference forces of the missing neighbours stay as dead forces
//   free     relaxed without load at fixed mass first; displacements are measured from there
//   osmosis  as free, but relaxed at the reference pressure of every cell; the water then stays
//   slab     periodic in y, frozen at the right side
//
// In: SI units. Out: displacement of the middle of the right side (m), cell_displacement.csv (centroids, m).
#pragma once

#include "micro/cells/network_equilibrium.h"
#include "micro/cells/tissue_block.h"
#include "run/run_context.h"
#include "run/scenario.h"

#include <functional>
#include <memory>

namespace turgor
{
/// What one or several searches for equilibrium took.
struct LatticeEffort
{
  int iterations = 0, factorisations = 0, increments = 0, escapes = 0;
  double residual = 0.; ///< of the last one, see EquilibriumSettings
};

class LatticeBlock
{
public:
  /// std::invalid_argument for parameters outside their range.
  LatticeBlock(const ParenchymaParameters &cell, unsigned int columns, unsigned int rows, Surfaces surfaces);

  /// Without load: with free surfaces the cells bulge until they balance. RunFailed if they cannot.
  LatticeEffort relax(const EquilibriumSettings &settings);

  /// Under `load` (Pa, downward) from the relaxed state, in as many increments as Newton's method needs.
  /// after(share of the load reached) after each; RunFailed where no shorter increment helps.
  LatticeEffort load(double load, const EquilibriumSettings &settings, const std::function<void(double)> &after = {});

  Vector<2> probe_displacement() const;                     ///< m, middle of the right side, from the relaxed state
  std::vector<Vector<2>> cell_displacement() const;         ///< m, centroids, from the relaxed state
  Vector<2> clamp_reaction() const;                         ///< N, of the slab's depth, that the clamp exerts
  const std::vector<double> &pressure() const { return equilibrium->last_evaluation().pressure; } ///< Pa per cell
  Vector<2> weight() const;                                 ///< N, body force on all fluid and walls
  Vector<2> dead_force() const;                             ///< N, sum of the missing neighbours' forces

  std::unique_ptr<HydrostaticNetwork> network;
  std::vector<std::uint32_t> clamped, probe; ///< nodes
  std::vector<double> reference, relaxed, x; ///< m, node positions in the periodic grid, before and under the load
  std::vector<double> failed;                ///< m, where the last search that found nothing has ended
  double width = 0.;                         ///< m
  double density = 0.;                       ///< kg/m^3 of the reference
  double acceleration = 0.;                  ///< m/s^2, as loaded
  double reference_pressure = 0.;            ///< Pa

private:
  void freeze(const CellLayout &all, bool slab);
  Vector<2> centroid(const std::vector<double> &at, std::size_t cell) const;

  Surfaces surfaces;
  std::vector<double> dead;
  std::unique_ptr<NetworkEquilibrium> equilibrium;
};

class StaticLattice final : public Scenario
{
public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

private:
  static struct FieldFrame frame_of(const LatticeBlock &block, const std::vector<double> &x, double share_of_load);
  void write_cells(RunContext &context, const LatticeBlock &block) const;

  ParenchymaParameters cell;
  unsigned int columns = 16, rows = 16;
  double load = 20e3;
  std::string surfaces = "frozen";
  EquilibriumSettings equilibrium;
  bool fields = true;
};

std::unique_ptr<Scenario> make_static_lattice();
} // namespace turgor
