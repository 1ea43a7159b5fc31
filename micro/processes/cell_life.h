// The life of all cells of a population over an interval between steps of the engine: a list of processes
// (process.h; thesis 5.3.1, C.1-C.3), each in its own file.
//
// At the start of the interval dt: the pressure of every cell from its virial stress; all processes change
// the cells, in the order of the list; volumes and radii are those of the end; then all processes rearrange
// the cells. First order in dt.
//
//   CellLife life(parameters);  life.declare(cells.particles);  life.add(cells, x, phase);
//   life.advance(cells, contacts, surroundings, dt, steps, threads, gather_others);
#pragma once

#include "micro/processes/cell_life_parameters.h"
#include "micro/processes/process.h"

#include <functional>
#include <memory>
#include <vector>

namespace turgor {
class CellLife {
 public:
  explicit CellLife(const CellLifeParameters &parameters);
  CellLife(const CellLife &) = delete;  // the processes read its parameters
  CellLife &operator=(const CellLife &) = delete;

  /// One more process, behind the others; before declare().
  void add(std::unique_ptr<Process> process) { processes.push_back(std::move(process)); }

  void declare(Particles<3> &particles) const;

  /// A cell with its fields at a phase of its cycle, uncompressed.
  void add(CellPopulation &cells, const Vector<3> &x, double phase) const;

  /// The life over dt (s). Contacts are those of the present positions (add_forces). steps: of the engine so
  /// far. gather_others(places): all that keeps something per cell beside the population; called where cells
  /// divide or go.
  void advance(CellPopulation &cells, const SphereContacts &contacts, const Surroundings &surroundings,
               double dt, std::uint64_t steps, unsigned int threads,
               const std::function<void(const Rearrangement &)> &gather_others);

  /// A step of dt (s) has been made.
  void after_step(CellPopulation &cells, double dt, std::uint64_t step);
  double longest_step() const;  ///< s

  /// Pa, of each cell, from contacts at the present positions.
  const std::vector<double> &measure_pressures(const CellPopulation &cells, const SphereContacts &contacts,
                                               unsigned int threads);

  void set_rim_thickness(const double thickness) { parameters.death.rim_thickness = thickness; }  ///< m

  double birth_volume() const { return parameters.birth_volume(); }  ///< m^3
  double volume(const CellPopulation &cells, std::size_t i) const;

  LifeCount count;

 private:
  CellLifeParameters parameters;
  std::vector<std::unique_ptr<Process>> processes;
  std::vector<Tensor2<3>> virial;
  std::vector<double> pressure;
};
}  // namespace turgor
