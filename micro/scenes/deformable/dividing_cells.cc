// How cells of a growing population divide.
#include "micro/geometry/cell_halves.h"
#include "micro/laws/random_turn.h"
#include "micro/scenes/deformable/growing_cells.h"
#include "run/cpu_clock.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace turgor {
Vector<3> GrowingCells::direction(const std::uint32_t mother) const {
  return parameters.division.choose(cells.surfaces->cells.column<std::uint64_t>("id")[mother],
                                    cells.touching->virial(mother, centre(mother)));
}

void GrowingCells::divide(const std::vector<DeformableLife::Due> &due) {
  cells.system.compute_forces();
  const double before = cells.energy();
  const std::size_t nodes = cells.system.particles.size();
  std::vector<Vector<3>> along;  // by contacts as they are now
  for (const auto &one : due) along.push_back(direction(one.mother));
  double dropped = 0.;
  std::vector<std::uint32_t> mothers;
  for (std::size_t k = 0; k < due.size(); ++k) {
    dropped += halve(due[k], along[k]);
    mothers.push_back(due[k].mother);
  }
  settle(mothers, nodes);
  cells.system.compute_forces();
  const double net = cells.energy() - before;
  division_work += net + dropped;
  division_dropped += dropped;
  cells.put_in(net);
  life.divisions += due.size();
}

void GrowingCells::settle(const std::vector<std::uint32_t> &mothers, const std::size_t nodes_before) {
  Particles<3> &p = cells.system.particles;
  Rearrangement places;
  places.source.resize(p.size());
  std::iota(places.source.begin(), places.source.end(), 0u);
  const auto renew = [&](const std::uint32_t begin, const std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      places.source[i] = Rearrangement::fresh;
      for (int d = 0; d < 3; ++d) p.v[d][i] = 0.;
    }
  };
  for (const std::uint32_t mother : mothers) renew(p.groups[mother].begin, p.groups[mother].end);
  renew(std::uint32_t(nodes_before), std::uint32_t(p.size()));
  cells.settle(places);
}

void GrowingCells::place(const std::uint32_t mother, const Vector<3> &along) {
  Particles<3> &p = cells.system.particles;
  CellSurfaces &surfaces = *cells.surfaces;
  const Group group = p.groups[mother];
  std::vector<Vector<3>> nodes;
  for (std::uint32_t i = group.begin; i < group.end; ++i) nodes.push_back(p.position(i));
  CellHalves::Faces faces;
  const auto [begin, end] = surfaces.triangles_of(mother);
  for (std::uint32_t k = begin; k < end; ++k) {
    const auto &[i, j, l] = surfaces.triangles[k];
    faces.push_back({i - group.begin, j - group.begin, l - group.begin});
  }
  const CellHalves halves(nodes, faces, along);
  const std::uint64_t id = surfaces.cells.column<std::uint64_t>("id")[mother];
  std::vector<Vector<3>> daughter[2];
  for (const int side : {0, 1}) {
    const Tensor2<3> turn =
        random_turn(mix_bits(parameters.life.variability.seed ^ 0x6e657473ull), 2 * id + std::uint64_t(side));
    std::vector<Vector<3>> directions;
    for (const Vector<3> &x : newborn.nodes) directions.push_back(turn * x.normalized());
    daughter[side] =
        halves.daughter(side, newborn.mesh, directions, parameters.material.rest, parameters.slides);
  }
  for (std::uint32_t i = group.begin; i < group.end; ++i)
    for (int d = 0; d < 3; ++d) p.x[d][i] = daughter[0][i - group.begin][d];
  surfaces.take_rest(mother, kind, 0);
  surfaces.add(p, kind, 0, daughter[1]);
}

double GrowingCells::halve(const DeformableLife::Due &due, const Vector<3> &along) {
  CellSurfaces &surfaces = *cells.surfaces;
  const double volume = surfaces.cells.column("rest_volume")[due.mother], before = strain(due.mother);
  const std::uint32_t second = std::uint32_t(size());
  const double start = thread_cpu_seconds();
  place(due.mother, along);
  for (const std::uint32_t cell : {due.mother, second}) life.newborn(surfaces, cell, 0.5 * volume, due.left);
  set_medium();
  const double dropped = relax(due.mother, second, before);
  dividing += thread_cpu_seconds() - start;
  ++timed;
  return dropped;
}

std::vector<std::uint32_t> GrowingCells::near(const std::uint32_t first, const std::uint32_t second) const {
  const Particles<3> &p = cells.system.particles;
  const double reach = parameters.material.law().reach() + parameters.material.edge();
  const auto extent = [&](const std::uint32_t cell, const int d) {
    const auto [low, high] =
        std::minmax_element(p.x[d].begin() + p.groups[cell].begin, p.x[d].begin() + p.groups[cell].end);
    return std::array<double, 2>{*low, *high};
  };
  double low[3], high[3];
  for (int d = 0; d < 3; ++d) {
    const auto a = extent(first, d), b = extent(second, d);
    low[d] = std::min(a[0], b[0]) - reach;
    high[d] = std::max(a[1], b[1]) + reach;
  }
  std::vector<std::uint32_t> found{first, second};
  for (std::uint32_t cell = 0; cell < size(); ++cell) {
    bool is = cell != first && cell != second;
    for (int d = 0; d < 3 && is; ++d) {
      const auto own = extent(cell, d);
      is = own[0] < high[d] && own[1] > low[d];
    }
    if (is) found.push_back(cell);
  }
  return found;
}

double GrowingCells::relax(const std::uint32_t first, const std::uint32_t second,
                           const double strain_before) {
  Particles<3> &p = cells.system.particles;
  DeformableCells pair(cells, near(first, second), 2);
  pair.begin(parameters.first_relaxation);
  const double before = pair.energy();
  for (unsigned int k = 0; k < parameters.relaxation; ++k, ++divided.steps) pair.step(HUGE_VAL);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t cell = k == 0 ? first : second;
    const Group &from = pair.system.particles.groups[k], &to = p.groups[cell];
    for (int d = 0; d < 3; ++d)
      std::copy(pair.system.particles.x[d].begin() + from.begin,
                pair.system.particles.x[d].begin() + from.end, p.x[d].begin() + to.begin);
    divided.least_volume = std::min(divided.least_volume, std::exp(strain_before - strain(cell)));
  }
  divided.rejected += pair.rejected();
  divided.least_angle = std::min(divided.least_angle, pair.least_angle());
  divided.lowest_gap = std::min(divided.lowest_gap, pair.touching->lowest_gap());
  return before - pair.energy();
}
}  // namespace turgor
