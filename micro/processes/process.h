// What happens to the cells of a population between steps of the engine: the face of all processes, which
// CellLife goes through in the order of its list (cell_life.cc). A process is one file and its line there;
// only Polarity needs what the scene has and is added where that is (cell_culture.cc).
//
//   change      at the start of an interval: states, strains, volumes of cells, each cell by itself. Radii
//               follow when all have changed
//   rearrange   when all have changed, in a second pass through the list: who divides, is born or goes
//   after_step  after each step of the interval
//
// Whatever is random is a function of a cell's id, and sums are in the order of cells: same bits on any
// number of threads. Columns that a process declares in the table of cells are archived, sorted and divided
// with it (table.h).
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/cells/surroundings.h"
#include "micro/terms/sphere_contacts.h"
#include "run/archive.h"

#include <cmath>
#include <functional>
#include <vector>

namespace turgor {
/// Since the start.
struct LifeCount {
  std::uint64_t divisions = 0, deaths = 0, removed = 0;
  double grown = 0.,
         drained =
             0.;  ///< m^3 of uncompressed volume: made by growth; lost by lysis, remains taken away included
  void archive(Archive &a) { a(divisions, deaths, removed, grown, drained); }
};

struct Interval {
  CellPopulation &cells;
  const SphereContacts &contacts;  ///< at the positions of its start
  const Surroundings &surroundings;
  double dt;  ///< s, its length
  unsigned int threads;
  std::uint64_t steps;                    ///< of the engine so far
  const std::vector<double> &pressure;    ///< Pa, of each cell at its start
  const std::vector<Tensor2<3>> &virial;  ///< N m
  /// All that keeps something per cell beside the population.
  const std::function<void(const Rearrangement &)> &gather_others;
  LifeCount &count;

  std::vector<unsigned char> deep;  ///< of each cell: below the viable rim
  struct Due {
    std::uint32_t mother;
    double left;  ///< of dt, s, which her daughters have
  };
  std::vector<Due> divisions;  ///< in the order of cells

  void gather(const Rearrangement &places) {
    cells.gather(places);
    gather_others(places);
  }
};

class Process {
 public:
  virtual ~Process() = default;
  virtual void declare(Particles<3> &) const {}
  virtual void change(Interval &) {}
  virtual void rearrange(Interval &) {}
  /// dt: s; step: its number.
  virtual void after_step(CellPopulation &, double /*dt*/, std::uint64_t /*step*/) {}
  virtual double longest_step() const { return HUGE_VAL; }  ///< s, that it can be held
};
}  // namespace turgor
