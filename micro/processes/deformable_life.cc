#include "micro/processes/deformable_life.h"

#include "run/archive.h"

#include <cmath>

namespace turgor {
void DeformableLife::declare(CellSurfaces &surfaces) {
  surfaces.cells.declare<std::uint64_t>("id");
  surfaces.cells.declare<std::uint8_t>("state");
  for (const char *name : {"phase", "cycle_time"}) surfaces.cells.declare(name);
}

void DeformableLife::draw(CellSurfaces &surfaces, const std::size_t cell) {
  const std::uint64_t id = next_id++;
  surfaces.cells.column<std::uint64_t>("id")[cell] = id;
  surfaces.cells.column<std::uint8_t>("state")[cell] = std::uint8_t(CellState::proliferating);
  surfaces.cells.column("cycle_time")[cell] =
      parameters.variability(parameters.cycle_time, id, Varied::cycle_time);
}

void DeformableLife::grow(CellSurfaces &surfaces, const std::size_t cell, const double volume) {
  const double before = surfaces.cells.column("rest_volume")[cell];
  if (volume == before) return;
  grown += volume - before;
  surfaces.grow(cell, volume);
}

void DeformableLife::begin(CellSurfaces &surfaces, const std::size_t cell, const double phase) {
  draw(surfaces, cell);
  const double T = surfaces.cells.column("cycle_time")[cell];
  double volume = parameters.birth_volume, reached = 0.;
  parameters.cycle.advance(parameters.growth, parameters.birth_volume, T, 1., phase * T, reached, volume);
  surfaces.cells.column("phase")[cell] = phase;
  surfaces.grow(cell, volume);
}

std::vector<DeformableLife::Due> DeformableLife::advance(CellSurfaces &surfaces,
                                                         const Particles<3> &particles, const double dt) {
  std::vector<Due> due;
  std::vector<double> &phase = surfaces.cells.column("phase");
  const std::vector<double> &T = surfaces.cells.column("cycle_time"),
                            &rest = surfaces.cells.column("rest_volume");
  std::vector<std::uint8_t> &state = surfaces.cells.column<std::uint8_t>("state");
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    const double strain = -std::log(surfaces.volume(particles, i) / rest[i]);
    double volume = rest[i];
    const CellCycle::Lived lived =
        parameters.cycle.live(parameters.growth, parameters.birth_volume, T[i], strain,
                              CellState(state[i]) == CellState::quiescent, false, dt, phase[i], volume);
    state[i] = std::uint8_t(lived.rests ? CellState::quiescent : CellState::proliferating);
    grow(surfaces, i, volume);
    if (lived.left >= 0.) due.push_back({i, lived.left});
  }
  return due;
}

void DeformableLife::newborn(CellSurfaces &surfaces, const std::size_t cell, const double half,
                             const double left) {
  draw(surfaces, cell);
  surfaces.grow(cell, half);
  double &phase = surfaces.cells.column("phase")[cell], volume = half;
  phase = 0.;
  parameters.cycle.advance(parameters.growth, parameters.birth_volume,
                           surfaces.cells.column("cycle_time")[cell], 1., left, phase, volume);
  grow(surfaces, cell, volume);
}

void DeformableLife::archive(Archive &a) {
  a.section("deformable_life");
  a(next_id, grown, divisions);
}
}  // namespace turgor
