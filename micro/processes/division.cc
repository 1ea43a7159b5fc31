#include "micro/processes/division.h"

#include <algorithm>
#include <numeric>

namespace turgor {
std::vector<Vector<3>> Division::offsets(const Interval &now) const {
  const CellPopulation &cells = now.cells;
  const std::vector<double> &R = cells.particles.field("radius");
  const CellDivision &law = parameters.division;
  double reach = 0.;
  for (const Interval::Due &due : now.divisions) reach = std::max(reach, CellDivision::reach(R[due.mother]));
  PairList<3> near(reach);
  if (law.least_energy) {
    std::vector<unsigned char> no_marks;
    near.build(cells.particles, R, no_marks, now.threads);
  }
  std::vector<Vector<3>> result;
  const double half = std::cbrt(0.5);
  for (const Interval::Due &due : now.divisions) {
    const Vector<3> along = law.choose(cells.id()[due.mother], now.virial[due.mother]);
    result.push_back(law.half_distance(cells, now.contacts, near, now.surroundings, due.mother, along,
                                       half * R[due.mother]) *
                     along);
  }
  return result;
}

void Division::newborn(Interval &now, const std::size_t i, const Vector<3> &offset, const double left) const {
  CellPopulation &cells = now.cells;
  Particles<3> &p = cells.particles;
  double &V_ref = p.field("reference_volume")[i], &phase = p.cells.column("phase")[i];
  cells.id()[i] = cells.next_id++;
  parameters.draw(cells, i);
  V_ref *= 0.5;
  phase = 0.;
  const double before = V_ref;
  parameters.cycle.advance(parameters.growth, parameters.birth_volume(), p.cells.column("cycle_time")[i], 1.,
                           left, phase, V_ref);
  now.count.grown += V_ref - before;
  p.field("radius")[i] = sphere_radius(compressed_volume(V_ref, p.cells.column("strain")[i]));
  for (int d = 0; d < 3; ++d) p.x[d][i] += offset[d];
}

void Division::rearrange(Interval &now) {
  if (now.divisions.empty()) return;
  const std::vector<Vector<3>> offset = offsets(now);
  Rearrangement places;
  const std::size_t before = now.cells.size();
  places.source.resize(before);
  std::iota(places.source.begin(), places.source.end(), 0u);
  for (const Interval::Due &due : now.divisions) places.source.push_back(due.mother);
  now.gather(places);
  for (std::size_t k = 0; k < now.divisions.size(); ++k) {
    const Interval::Due &due = now.divisions[k];
    newborn(now, due.mother, offset[k], due.left);
    newborn(now, before + k, -offset[k], due.left);
    ++now.count.divisions;
  }
}
}  // namespace turgor
