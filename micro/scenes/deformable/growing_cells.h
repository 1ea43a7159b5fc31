// A population of deformable cells that grow and divide: what the scenes of their spheroids run.
//
// An interval: at its start the cells live (deformable_life.h) for all of it, then steps of motion until its
// end. Mothers that are due become two daughters each:
//
//   where       cell_halves.h: both halves of the mother's present shape, of equal volume, in a direction
//   that is
//               random, given, or that in which contacts press her least; nets of random orientation
//   what        at rest each is a sphere of half of the mother's volume at rest: her material, new nets
//   relaxation  the daughters alone move, steps of a sub-simulation, while all cells near by are held (B.2);
//   then
//               all go on together, in steps as long as before. The time of these steps is no time of the
//               population's
//
// Books, J: growth_work, what the growing reference state puts into the cells, by the trapezoidal rule of
// dE/d ln s over d ln s between the start and the end of intervals (s: scale of lengths at rest);
// division_work, the energy of two daughters in their halves less that of their mother; division_dropped,
// what they lose of it in their sub-simulations, to friction and to steps of finite length; newborn_lost,
// what steps of the population, longer than daughters take to relax, lose of it afterwards instead of turning
// it to heat: of what a step loses the share of those that have not begun to grow again, where a cell loses
// h v . (F - F')/2 over its nodes (or nothing, where that is negative) in a step of h from forces F to F'.
//
//   GrowingCells tissue(parameters, centres, phases, threads);
//   tissue.step(limit);
#pragma once

#include "micro/processes/cell_division.h"
#include "micro/processes/deformable_life.h"
#include "micro/scenes/deformable/deformable_cells.h"

namespace turgor {
struct GrowingCellsParameters {
  TouchingMaterial material;  ///< radius: at birth
  DeformableLifeParameters life;
  CellDivision division;          ///< direction, axis and seed alone
  double interval = 120.;         ///< s
  unsigned int slides = 10;       ///< sweeps of daughters' nodes (cell_halves.h)
  unsigned int relaxation = 10;   ///< steps of a sub-simulation
  double first_relaxation = 0.1;  ///< s, the first of them
};

class GrowingCells {
 public:
  /// centres: m, of the first cells; phases: of their cycles.
  GrowingCells(const GrowingCellsParameters &parameters, const std::vector<Vector<3>> &centres,
               const std::vector<double> &phases, unsigned int threads);
  GrowingCells(const GrowingCells &) = delete;

  void begin() { cells.begin(std::min(1., parameters.interval)); }
  /// At most `limit` (s).
  void step(double limit);

  Vector<3> centre(std::size_t cell) const;  ///< m, of the volume
  double strain(std::size_t cell) const;     ///< -log(V/V_0)
  std::size_t count(CellState which) const;
  std::size_t size() const { return cells.surfaces->size(); }

  DeformableCells cells;
  DeformableLife life;
  double growth_work = 0., division_work = 0., division_dropped = 0., newborn_lost = 0.;  ///< J
  /// Of all divisions: steps of their sub-simulations, those rejected, and how they leave the daughters.
  struct Divisions {
    std::uint64_t steps = 0, rejected = 0;
    double least_volume = 1.;  ///< of a daughter over its volume at rest, relative to the mother's
    double least_angle = 4.;   ///< rad
    double lowest_gap = 1.;    ///< m, to any other cell
  } divided;
  double dividing = 0.;     ///< CPU s, of divisions since this was made, of which there were
  std::uint64_t timed = 0;  ///< so many

  void archive_population(Archive &a);  ///< before the cells' own

 private:
  void live(double dt);
  /// The growth of a cell since the interval began has done its work, where the cell is now.
  void book_growth(std::size_t cell);
  /// J, of what a step of h (s) from these forces (N) has lost: of newborn cells.
  double newborn_share(double lost, double h, const Particles<3>::Components &before) const;
  void divide(const std::vector<DeformableLife::Due> &due);
  Vector<3> direction(std::uint32_t mother) const;
  /// The mother's place is the first daughter's, the second is behind all cells. Returns what the
  /// sub-simulation took from the energy, J.
  double halve(const DeformableLife::Due &due, const Vector<3> &along);
  double relax(std::uint32_t first, std::uint32_t second, double strain_before);
  void place(std::uint32_t mother, const Vector<3> &along);
  std::vector<std::uint32_t> near(std::uint32_t first, std::uint32_t second) const;
  void set_medium();
  void settle(const std::vector<std::uint32_t> &mothers, std::size_t nodes_before);

  GrowingCellsParameters parameters;
  DeformableShape newborn;  ///< the sphere
  CellSurfaces kind;        ///< the same, free of stress
  double until = 0.;        ///< s, end of the interval
};
}  // namespace turgor
