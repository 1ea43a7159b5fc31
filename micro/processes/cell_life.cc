#include "micro/processes/cell_life.h"

#include "micro/cells/cell_stress.h"
#include "micro/processes/division.h"
#include "micro/processes/lysis.h"
#include "micro/processes/necrosis.h"
#include "micro/processes/proliferation.h"
#include "micro/processes/strain_relaxation.h"
#include "micro/processes/viable_rim.h"

#include <algorithm>

namespace turgor {
// Two passes (process.h), each in this order. In the first, change: who dies now begins to drain in the next
// interval, and Proliferation, last, notes who is due. In the second, rearrange: Division, which has no part
// in the first, divides those, and then Lysis takes remains away: they count as neighbours of those that
// divide.
CellLife::CellLife(const CellLifeParameters &parameters_) : parameters(parameters_) {
  add(std::make_unique<ViableRim>(parameters));
  add(std::make_unique<StrainRelaxation>(parameters));
  add(std::make_unique<Division>(parameters));
  add(std::make_unique<Lysis>(parameters));
  add(std::make_unique<Necrosis>(parameters));
  add(std::make_unique<Proliferation>(parameters));
}

void CellLife::declare(Particles<3> &particles) const {
  for (const auto &process : processes) process->declare(particles);
}

void CellLife::add(CellPopulation &cells, const Vector<3> &x, const double phase) const {
  const std::size_t i = cells.add(x, parameters.birth_radius, parameters.modulus);
  parameters.draw(cells, i);
  const double T = cells.particles.cells.column("cycle_time")[i];
  double V_ref = birth_volume(), reached = 0.;
  parameters.cycle.advance(parameters.growth, birth_volume(), T, 1., phase * T, reached, V_ref);
  cells.particles.field("reference_volume")[i] = V_ref;
  cells.particles.cells.column("phase")[i] = phase;
  cells.particles.field("radius")[i] = sphere_radius(V_ref);
}

double CellLife::volume(const CellPopulation &cells, const std::size_t i) const {
  return compressed_volume(cells.particles.field("reference_volume")[i],
                           cells.particles.cells.column("strain")[i]);
}

const std::vector<double> &CellLife::measure_pressures(const CellPopulation &cells,
                                                       const SphereContacts &contacts,
                                                       const unsigned int threads) {
  cell_virials(cells.particles, contacts, threads, virial);
  cells.add_virials(virial);
  const std::vector<double> &V_ref = cells.particles.field("reference_volume"),
                            &eps = cells.particles.cells.column("strain");
  pressure.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    pressure[i] = -virial[i].trace() / (3. * compressed_volume(V_ref[i], eps[i]));
  return pressure;
}

void CellLife::advance(CellPopulation &cells, const SphereContacts &contacts,
                       const Surroundings &surroundings, const double dt, const std::uint64_t steps,
                       const unsigned int threads,
                       const std::function<void(const Rearrangement &)> &gather_others) {
  measure_pressures(cells, contacts, threads);
  Interval now{cells,    contacts, surroundings,  dt,    threads, steps,
               pressure, virial,   gather_others, count, {},      {}};
  for (const auto &process : processes) process->change(now);
  std::vector<double> &R = cells.particles.field("radius");
  for (std::size_t i = 0; i < cells.size(); ++i) R[i] = sphere_radius(volume(cells, i));
  for (const auto &process : processes) process->rearrange(now);
}

void CellLife::after_step(CellPopulation &cells, const double dt, const std::uint64_t step) {
  for (const auto &process : processes) process->after_step(cells, dt, step);
}

double CellLife::longest_step() const {
  double longest = HUGE_VAL;
  for (const auto &process : processes) longest = std::min(longest, process->longest_step());
  return longest;
}
}  // namespace turgor
