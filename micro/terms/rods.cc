#include "micro/terms/rods.h"

#include "micro/solve/motion_matrix.h"

#include <algorithm>

namespace turgor {
void RodSet::add(Particles<3> &particles, const std::vector<Vector<3>> &ends_a,
                 const std::vector<Vector<3>> &ends_b) {
  constexpr std::uint32_t together = 64;
  first = std::uint32_t(particles.size());
  const std::uint32_t end = first + 2 * std::uint32_t(ends_a.size());
  particles.resize(end);
  for (std::uint32_t begin = first; begin < end; begin += 2 * together) {
    const std::uint32_t last = std::min(end, begin + 2 * together);
    particles.groups.push_back({begin, last, last});
  }
  for (std::size_t rod = 0; rod < ends_a.size(); ++rod)
    for (int d = 0; d < 3; ++d) {
      particles.x[d][a(rod)] = ends_a[rod][d];
      particles.x[d][b(rod)] = ends_b[rod][d];
    }
}

std::array<std::size_t, 2> RodSet::of_group(const Particles<3> &particles, const std::size_t group) const {
  const Group &g = particles.groups[group];
  if (g.begin < first) return {0, 0};
  return {(g.begin - first) / 2, (g.end - first) / 2};
}

RodBodies::RodBodies(std::shared_ptr<RodSet> rods_) : rods(std::move(rods_)) {}

void RodBodies::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  const auto [begin, end] = rods->of_group(particles, group);
  for (std::size_t rod = begin; rod < end; ++rod) {
    const RodSet::Line line = rods->line(particles, rod);
    const double over = rods->shape[rod].at(line.L).pull_over_length;
    for (int d = 0; d < 3; ++d) {
      const double pull = over * (line.b[d] - line.a[d]);
      particles.f[d][rods->a(rod)] += pull;
      particles.f[d][rods->b(rod)] -= pull;
    }
  }
}

void RodBodies::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  for (std::size_t rod = 0; rod < rods->size(); ++rod) {
    const RodSet::Line line = rods->line(particles, rod);
    const RodShape::At at = rods->shape[rod].at(line.L);
    const double along = rods->inner_friction * (1. + at.slope * at.slope) + h * at.slope_of_pull;
    const bool has_line = line.L > 0. && line.u.squaredNorm() > 0.;
    matrix.link<3>(rods->a(rod), rods->b(rod), has_line ? line.u : Vector<3>(Vector<3>::UnitX()), along,
                   has_line ? h * at.pull_over_length : along);
  }
}

double RodBodies::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const {
  double total = 0.;
  const auto [begin, end] = rods->of_group(particles, group);
  for (std::size_t rod = begin; rod < end; ++rod)
    total += rods->shape[rod].energy(rods->line(particles, rod).L);
  return total;
}
}  // namespace turgor
