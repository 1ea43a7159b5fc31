// The life of deformable cells between steps of the engine: the cycle of centre-based cells
// (laws/cell_cycle.h: growth, inhibition by volumetric strain, rest, division) on their reference volume,
// which the surfaces' reference state follows (CellSurfaces::grow, thesis B.17, B.2).
//
//   strain   eps = -log(V/V_0) = p/K of the content, positive in compression
//   birth    at V_0 = birth_volume and phase 0; each has its own cycle time, drawn by its id
//   due      cells at the end of their cycle, in the order of cells, each with what is left of the interval
//
// Columns of the table of cells: id (never used again; both daughters are new cells), state (CellState),
// phase (none), cycle_time (s).
//
//   DeformableLife life(parameters);  life.declare(surfaces);  life.begin(surfaces, cell, phase);
//   for (const auto &due : life.advance(surfaces, particles, dt)) ...
#pragma once

#include "micro/laws/cell_cycle.h"
#include "micro/laws/cell_state.h"
#include "micro/laws/cell_variability.h"
#include "micro/terms/cell_surfaces.h"

namespace turgor {
struct DeformableLifeParameters {
  double birth_volume = 0.;         ///< m^3, V_0
  double cycle_time = 24. * 3600.;  ///< s, mean T
  GrowthLaw growth;
  CellCycle cycle;
  CellVariability variability;
};

class DeformableLife {
 public:
  explicit DeformableLife(const DeformableLifeParameters &parameters_) : parameters(parameters_) {}

  static void declare(CellSurfaces &surfaces);

  /// A cell begins at a phase of its cycle, as large at rest as free growth makes it by then.
  void begin(CellSurfaces &surfaces, std::size_t cell, double phase);

  struct Due {
    std::uint32_t mother;
    double left;  ///< s
  };
  /// All cells live for dt (s); who is due to divide.
  std::vector<Due> advance(CellSurfaces &surfaces, const Particles<3> &particles, double dt);

  /// A cell is a daughter now: a new one, of half of V_0 of the mother in its place, which has lived for
  /// `left` (s).
  void newborn(CellSurfaces &surfaces, std::size_t cell, double half, double left);

  std::uint64_t born() const { return next_id; }  ///< ids given so far
  double grown = 0.;                              ///< m^3 of reference volume, made since the start
  std::uint64_t divisions = 0;

  void archive(Archive &a);

 private:
  /// A new id and what is drawn by it.
  void draw(CellSurfaces &surfaces, std::size_t cell);
  /// The cell at rest has another volume.
  void grow(CellSurfaces &surfaces, std::size_t cell, double volume);

  DeformableLifeParameters parameters;
  std::uint64_t next_id = 0;
};
}  // namespace turgor
