#include "micro/terms/lamella_ties.h"

#include <cmath>

namespace turgor
{
LamellaTies::LamellaTies(std::vector<LamellaTie> ties_, const double stiffness, const double node_mass_)
  : ties(std::move(ties_))
  , spring{stiffness}
  , node_mass(node_mass_)
{}

void LamellaTies::declare(Particles<2> &particles)
{
  std::vector<std::uint32_t> group_of(particles.size());
  for (std::size_t group = 0; group < particles.groups.size(); ++group)
    for (std::uint32_t i = particles.groups[group].begin; i < particles.groups[group].end; ++i)
      group_of[i] = std::uint32_t(group);
  sides.assign(particles.groups.size(), {});
  for (const LamellaTie &tie : ties)
    {
      sides[group_of[tie.a]].push_back({tie.a, tie.b, tie.shift});
      sides[group_of[tie.b]].push_back({tie.b, tie.a, {-tie.shift[0], -tie.shift[1]}});
    }
}

void LamellaTies::add_forces(Particles<2> &particles, const Box<2> &box, const std::size_t group)
{
  const double *x = particles.x[0].data(), *y = particles.x[1].data();
  double *fx = particles.f[0].data(), *fy = particles.f[1].data();
  const double k = spring.stiffness;
  for (const Side &side : sides[group])
    {
      double dx = x[side.other] - x[side.own], dy = y[side.other] - y[side.own];
      dx += side.shift[0] * box.H(0, 0) + side.shift[1] * box.H(0, 1);
      dy += side.shift[0] * box.H(1, 0) + side.shift[1] * box.H(1, 1);
      fx[side.own] += k * dx;
      fy[side.own] += k * dy;
    }
}

double LamellaTies::energy(const Particles<2> &particles, const Box<2> &box, const std::size_t group) const
{
  double total = 0.;
  for (const Side &side : sides[group])
    total += 0.5 * spring.energy(LamellaSpring::gap(particles.position(side.own), particles.position(side.other),
                                                    side.shift, box.H));
  return total;
}

Tensor2<2> LamellaTies::image_virial(const Particles<2> &particles, const Box<2> &box, const std::size_t group) const
{
  Tensor2<2> total = Tensor2<2>::Zero();
  for (const Side &side : sides[group])
    {
      const Vector<2> shift = box.image(side.shift);
      const Vector<2> d = particles.position(side.other) - particles.position(side.own) + shift;
      total += 0.5 * spring.force_on_a(d) * shift.transpose();
    }
  return total;
}

Rates LamellaTies::rates(const Particles<2> &) const
{
  // A corner node carries two ties, each to a node that carries two: Gershgorin on its row.
  Rates bound;
  bound.wall.frequency_squared = 4. * spring.stiffness / node_mass;
  return bound;
}
} // namespace turgor
