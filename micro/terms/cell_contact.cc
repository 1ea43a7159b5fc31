#include "micro/terms/cell_contact.h"

#include "micro/engine/binary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor
{
CellContact::CellContact(const double stiffness_, const double reach_, const double skin_, const double node_mass_,
                         std::shared_ptr<const WallDamage> damage_)
  : stiffness(stiffness_)
  , reach(reach_)
  , skin(skin_)
  , node_mass(node_mass_)
  , damage(std::move(damage_))
{}

void CellContact::declare(Particles<2> &particles)
{
  of_points.assign(particles.groups.size(), {});
  of_rings.assign(particles.groups.size(), {});
  failed_at_build.assign(particles.groups.size(), 0);
}

std::uint32_t CellContact::points_end(const Particles<2> &particles, const std::size_t group) const
{
  const Group &g = particles.groups[group];
  return failed_at_build[group] ? g.end : g.fluid;
}

bool CellContact::stale(const Particles<2> &particles) const
{
  if (origin[0].empty())
    return true;
  const double allowed = 0.25 * skin * skin;
  for (std::size_t group = 0; group < particles.groups.size(); ++group)
    {
      if (damage && bool(failed_at_build[group]) != damage->cells[group].failed())
        return true;
      for (std::uint32_t i = particles.groups[group].begin; i < points_end(particles, group); ++i)
        {
          const double dx = particles.x[0][i] - origin[0][i], dy = particles.x[1][i] - origin[1][i];
          if (!(dx * dx + dy * dy <= allowed))
            return true;
        }
    }
  return false;
}

void CellContact::prepare(const Particles<2> &particles, const Box<2> &)
{
  if (!stale(particles))
    return;
  for (std::size_t group = 0; group < particles.groups.size(); ++group)
    failed_at_build[group] = damage && damage->cells[group].failed();
  origin = particles.x;
  build(particles);
  ++builds;
}

void CellContact::build(const Particles<2> &particles)
{
  const std::size_t cells = particles.groups.size();
  const double range = reach + skin;
  bonds.clear();
  nears.clear();
  for (auto *lists : {&of_points, &of_rings})
    for (auto &list : *lists)
      list.clear();

  struct Span
  {
    double low[2], high[2];
  };
  const auto span = [&](const std::uint32_t begin, const std::uint32_t end) {
    Span s;
    for (int d = 0; d < 2; ++d)
      {
        const auto [low, high] = std::minmax_element(origin[d].begin() + begin, origin[d].begin() + end);
        s.low[d] = *low;
        s.high[d] = *high;
      }
    return s;
  };
  std::vector<Span> ring(cells), points(cells);
  for (std::size_t c = 0; c < cells; ++c)
    {
      ring[c] = span(particles.groups[c].begin, particles.groups[c].fluid);
      points[c] = span(particles.groups[c].begin, points_end(particles, c));
    }
  for (std::size_t a = 0; a < cells; ++a)
    for (std::size_t b = 0; b < cells; ++b)
      {
        const auto apart = [&](const double low, const double high, const int d) {
          return low > ring[b].high[d] + range || high < ring[b].low[d] - range;
        };
        if (a == b || apart(points[a].low[0], points[a].high[0], 0) || apart(points[a].low[1], points[a].high[1], 1))
          continue;
        const Group &other = particles.groups[b];
        for (std::uint32_t i = particles.groups[a].begin; i < points_end(particles, a); ++i)
          {
            const double x = origin[0][i], y = origin[1][i];
            if (apart(x, x, 0) || apart(y, y, 1))
              continue;
            const std::uint32_t first = std::uint32_t(bonds.size());
            for (std::uint32_t k = other.begin; k < other.fluid; ++k)
              {
                const std::uint32_t next = k + 1 < other.fluid ? k + 1 : other.begin;
                const double ex = origin[0][next] - origin[0][k], ey = origin[1][next] - origin[1][k];
                const double px = x - origin[0][k], py = y - origin[1][k], l2 = ex * ex + ey * ey;
                const double t = l2 > 0. ? std::clamp((px * ex + py * ey) / l2, 0., 1.) : 0.;
                const double rx = px - t * ex, ry = py - t * ey;
                if (rx * rx + ry * ry < range * range)
                  bonds.push_back(k);
              }
            if (bonds.size() > first)
              {
                of_points[a].push_back(std::uint32_t(nears.size()));
                of_rings[b].push_back(std::uint32_t(nears.size()));
                nears.push_back({i, std::uint32_t(b), first, std::uint32_t(bonds.size())});
              }
          }
      }
}

CellContact::Hit CellContact::nearest(const Particles<2> &particles, const Near &near) const
{
  const Group &g = particles.groups[near.cell];
  const double *x = particles.x[0].data(), *y = particles.x[1].data();
  const double px = x[near.point], py = y[near.point];
  double least = std::numeric_limits<double>::infinity();
  Hit hit;
  for (std::uint32_t k = near.first; k < near.last; ++k)
    {
      const std::uint32_t a = bonds[k], b = a + 1 < g.fluid ? a + 1 : g.begin;
      const double ex = x[b] - x[a], ey = y[b] - y[a], qx = px - x[a], qy = py - y[a];
      const double l2 = ex * ex + ey * ey, t = l2 > 0. ? std::clamp((qx * ex + qy * ey) / l2, 0., 1.) : 0.;
      const double rx = t * ex - qx, ry = t * ey - qy, r2 = rx * rx + ry * ry;
      if (r2 < least)
        {
          least = r2;
          hit.a = a;
          hit.b = b;
          hit.t = t;
          hit.to_ring = {rx, ry};
        }
    }
  // A broken bond still holds foreign cells back: left out, what slips through the crack would find itself deep behind
  // the next bond at once, with that bond's energy from nothing.
  if (!(least < reach * reach))
    return hit;
  const auto cross = [&](const std::uint32_t o, const std::uint32_t e, const double qx, const double qy) {
    return (x[e] - x[o]) * qy - (y[e] - y[o]) * qx;
  };
  if (hit.t > 0. && hit.t < 1.)
    hit.inside = cross(hit.a, hit.b, px - x[hit.a], py - y[hit.a]) > 0.;
  else
    {
      const std::uint32_t at = hit.t > 0. ? hit.b : hit.a;
      const std::uint32_t before = at > g.begin ? at - 1 : g.fluid - 1, after = at + 1 < g.fluid ? at + 1 : g.begin;
      hit.inside = cross(before, at, x[after] - x[at], y[after] - y[at]) < 0.; // concave: what is nearest to it is inside
    }
  return hit;
}

void CellContact::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group)
{
  double *fx = particles.f[0].data(), *fy = particles.f[1].data();
  for (const std::uint32_t n : of_points[group])
    {
      const Hit hit = nearest(particles, nears[n]);
      if (!hit.inside)
        continue;
      fx[nears[n].point] += stiffness * hit.to_ring[0];
      fy[nears[n].point] += stiffness * hit.to_ring[1];
    }
  for (const std::uint32_t n : of_rings[group])
    {
      const Hit hit = nearest(particles, nears[n]);
      if (!hit.inside)
        continue;
      const double kx = stiffness * hit.to_ring[0], ky = stiffness * hit.to_ring[1];
      fx[hit.a] -= (1. - hit.t) * kx;
      fy[hit.a] -= (1. - hit.t) * ky;
      fx[hit.b] -= hit.t * kx;
      fy[hit.b] -= hit.t * ky;
    }
}

double CellContact::energy(const Particles<2> &particles, const Box<2> &, const std::size_t group) const
{
  double total = 0.;
  for (const std::uint32_t n : of_points[group])
    {
      const Hit hit = nearest(particles, nears[n]);
      if (hit.inside)
        total += 0.5 * stiffness * hit.to_ring.squaredNorm();
    }
  return total;
}

double CellContact::deepest(const Particles<2> &particles) const
{
  double most = 0.;
  for (const Near &near : nears)
    {
      const Hit hit = nearest(particles, near);
      if (hit.inside)
        most = std::max(most, hit.to_ring.norm());
    }
  return most;
}

Rates CellContact::rates(const Particles<2> &particles) const
{
  // A node held by a foreign bond, and two foreign nodes on either bond of its own: rows of at most 4 k.
  Rates bound;
  bound.wall.frequency_squared = 4. * stiffness / node_mass;
  if (damage)
    for (const Group &g : particles.groups)
      if (g.fluid_count() > 0)
        bound.fluid.frequency_squared = std::max(bound.fluid.frequency_squared, 2. * stiffness * particles.inverse_mass[g.fluid]);
  return bound;
}

void CellContact::save(std::ostream &out, const Particles<2> &) const
{
  write_binary(out, origin[0]);
  write_binary(out, origin[1]);
  write_binary(out, failed_at_build);
}

void CellContact::load(std::istream &in, Particles<2> &particles)
{
  read_binary(in, origin[0]);
  read_binary(in, origin[1]);
  read_binary(in, failed_at_build);
  if (!origin[0].empty())
    build(particles);
}
} // namespace turgor
