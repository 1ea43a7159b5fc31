#include "micro/terms/lamella_ties.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
LamellaTies::LamellaTies(std::vector<LamellaTie> ties_, const double node_mass_, const double breaking_force_)
    : ties(std::move(ties_)),
      node_mass(node_mass_),
      breaking_force(breaking_force_),
      broken(breaking_force_ > 0. ? ties.size() : 0, 0) {}

void LamellaTies::declare(Particles<2> &particles) {
  std::vector<std::uint32_t> group_of(particles.size());
  for (std::size_t group = 0; group < particles.groups.size(); ++group)
    for (std::uint32_t i = particles.groups[group].begin; i < particles.groups[group].end; ++i)
      group_of[i] = std::uint32_t(group);
  sides.assign(particles.groups.size(), {});
  for (std::uint32_t t = 0; t < ties.size(); ++t) {
    const LamellaTie &tie = ties[t];
    sides[group_of[tie.a]].push_back({tie.a, tie.b, tie.shift, t, tie.stiffness});
    sides[group_of[tie.b]].push_back({tie.b, tie.a, {-tie.shift[0], -tie.shift[1]}, t, tie.stiffness});
  }
}

void LamellaTies::add_forces(Particles<2> &particles, const Box<2> &box, const std::size_t group) {
  const double *x = particles.x[0].data(), *y = particles.x[1].data();
  double *fx = particles.f[0].data(), *fy = particles.f[1].data();
  for (const Side &side : sides[group]) {
    if (is_broken(side.tie)) continue;
    double dx = x[side.other] - x[side.own], dy = y[side.other] - y[side.own];
    dx += side.shift[0] * box.H(0, 0) + side.shift[1] * box.H(0, 1);
    dy += side.shift[0] * box.H(1, 0) + side.shift[1] * box.H(1, 1);
    fx[side.own] += side.stiffness * dx;
    fy[side.own] += side.stiffness * dy;
  }
}

double LamellaTies::energy(const Particles<2> &particles, const Box<2> &box, const std::size_t group) const {
  double total = 0.;
  for (const Side &side : sides[group])
    if (!is_broken(side.tie))
      total += 0.5 * LamellaSpring{side.stiffness}.energy(LamellaSpring::gap(
                         particles.position(side.own), particles.position(side.other), side.shift, box.H));
  return total;
}

Tensor2<2> LamellaTies::image_virial(const Particles<2> &particles, const Box<2> &box,
                                     const std::size_t group) const {
  Tensor2<2> total = Tensor2<2>::Zero();
  for (const Side &side : sides[group]) {
    if (is_broken(side.tie)) continue;
    const Vector<2> shift = box.image(side.shift);
    const Vector<2> d = particles.position(side.other) - particles.position(side.own) + shift;
    total += 0.5 * LamellaSpring{side.stiffness}.force_on_a(d) * shift.transpose();
  }
  return total;
}

Rates LamellaTies::rates(const Particles<2> &) const {
  // A corner node carries two ties, each to a node that carries two: Gershgorin on its row.
  Rates bound;
  for (const LamellaTie &tie : ties)
    bound.wall.frequency_squared = std::max(bound.wall.frequency_squared, 4. * tie.stiffness / node_mass);
  return bound;
}

void LamellaTies::archive(Archive &a, Particles<2> &) {
  a.section("ties");
  if (breaking_force > 0.) a.fixed(broken);
}

std::vector<std::size_t> LamellaTies::break_overloaded(const Particles<2> &particles, const Box<2> &box) {
  std::vector<std::size_t> now;
  for (std::size_t t = 0; t < broken.size(); ++t)
    if (!broken[t] &&
        ties[t].stiffness * LamellaSpring::gap(particles.position(ties[t].a), particles.position(ties[t].b),
                                               ties[t].shift, box.H)
                                .norm() >
            breaking_force) {
      broken[t] = 1;
      now.push_back(t);
    }
  return now;
}

std::size_t LamellaTies::broken_count() const {
  return std::size_t(std::count(broken.begin(), broken.end(), 1));
}
}  // namespace turgor
