#include "micro/terms/cell_contact.h"

#include "run/archive.h"
#include "micro/geometry/bins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace turgor
{
namespace
{
std::uint32_t next_in(const Group &g, const std::uint32_t k) { return k + 1 < g.fluid ? k + 1 : g.begin; }
} // namespace

CellContact::CellContact(const CellContactParameters &parameters_, std::shared_ptr<const WallDamage> damage_)
  : parameters(parameters_)
  , damage(std::move(damage_))
{}

void CellContact::declare(Particles<2> &particles)
{
  groups = particles.groups;
  of_points.assign(groups.size(), {});
  of_rings.assign(groups.size(), {});
  broken_at_build.assign(groups.size(), 0);
  on_face.clear();
  for (const Group &g : groups)
    on_face.emplace_back(2 * g.wall_count(), 0.);
  if (damage)
    fluid_range.assign(particles.size(), -1.); // -1: not out yet
  y = particles.x;
}

std::uint32_t CellContact::points_end(const std::size_t group) const
{
  return broken_at_build[group] > 0 ? groups[group].end : groups[group].fluid;
}

void CellContact::place(const Particles<2> &particles, Particles<2>::Components &at) const
{
  for (std::size_t group = 0; group < groups.size(); ++group)
    {
      const Group &g = groups[group];
      parameters.surface.place(particles, g, at);
      for (int d = 0; d < 2; ++d)
        std::copy(particles.x[d].begin() + g.fluid, particles.x[d].begin() + points_end(group), at[d].begin() + g.fluid);
    }
}

bool CellContact::stale()
{
  if (origin[0].empty())
    return true;
  if (damage)
    for (std::size_t group = 0; group < groups.size(); ++group)
      if (broken_at_build[group] != damage->cells[group].broken)
        return true;
  double most = 0.;
  bool wild = false; // not a number
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (std::uint32_t i = groups[group].begin; i < points_end(group); ++i)
      {
        const double dx = y[0][i] - origin[0][i], dy = y[1][i] - origin[1][i], r2 = dx * dx + dy * dy;
        wild = wild || !(r2 < std::numeric_limits<double>::infinity());
        most = std::max(most, r2);
      }
  moved = std::sqrt(most);
  return wild || moved > 0.5 * parameters.skin;
}

void CellContact::prepare(const Particles<2> &particles, const Box<2> &)
{
  place(particles, y);
  if (!stale())
    return;
  if (damage)
    {
      for (std::size_t group = 0; group < groups.size(); ++group)
        broken_at_build[group] = damage->cells[group].broken;
      place(particles, y); // fluid that is out now
    }
  origin = y;
  build();
  update_ranges();
  ++builds;
}

void CellContact::build()
{
  bonds.clear();
  nears.clear();
  moved = 0.;
  for (auto *lists : {&of_points, &of_rings})
    for (auto &list : *lists)
      list.clear();

  // Middles of the bonds that hold, in bins; a point looks as far as its reach and half the longest bond.
  std::vector<double> middle[2];
  std::vector<std::uint32_t> node, ring;
  double longest2 = 0., lo[2] = {0., 0.}, hi[2] = {0., 0.};
  for (std::size_t c = 0; c < groups.size(); ++c)
    for (std::uint32_t k = groups[c].begin; k < groups[c].fluid; ++k)
      {
        const std::uint32_t next = next_in(groups[c], k);
        const double ex = origin[0][next] - origin[0][k], ey = origin[1][next] - origin[1][k];
        if ((damage && damage->cells[c].bond_broken[k - groups[c].begin]) || !(std::abs(ex) + std::abs(ey) < 1e300))
          continue;
        longest2 = std::max(longest2, ex * ex + ey * ey);
        for (int d = 0; d < 2; ++d)
          {
            const double m = 0.5 * (origin[d][k] + origin[d][next]);
            lo[d] = node.empty() ? m : std::min(lo[d], m);
            hi[d] = node.empty() ? m : std::max(hi[d], m);
            middle[d].push_back(m);
          }
        node.push_back(k);
        ring.push_back(std::uint32_t(c));
      }
  if (node.empty())
    return;
  const double range = std::max(parameters.range, parameters.fluid_range) + parameters.skin, reach = range + 0.5 * std::sqrt(longest2);
  const double *const at[2] = {middle[0].data(), middle[1].data()};
  const Bins<2> bins(at, std::uint32_t(node.size()), 0.5 * reach * (1. + 1e-9), lo, hi);

  std::vector<std::uint32_t> found;
  for (std::size_t c = 0; c < groups.size(); ++c)
    for (std::uint32_t i = groups[c].begin; i < points_end(c); ++i)
      {
        const double p[2] = {origin[0][i], origin[1][i]};
        if (!(std::abs(p[0]) + std::abs(p[1]) < 1e300))
          continue;
        const bool fluid = i >= groups[c].fluid;
        found.clear();
        bins.near(p, [&](const std::uint32_t b) {
          const std::uint32_t k = node[b], next = next_in(groups[ring[b]], k);
          if (ring[b] == c && (fluid || k == i || next == i))
            return; // fluid and its own wall are the fluid's matter
          const double ex = origin[0][next] - origin[0][k], ey = origin[1][next] - origin[1][k];
          const double qx = p[0] - origin[0][k], qy = p[1] - origin[1][k], l2 = ex * ex + ey * ey;
          const double t = l2 > 0. ? std::clamp((qx * ex + qy * ey) / l2, 0., 1.) : 0.;
          const double rx = qx - t * ex, ry = qy - t * ey;
          if (rx * rx + ry * ry < range * range)
            found.push_back(b);
        });
        std::sort(found.begin(), found.end());
        for (std::size_t k = 0; k < found.size();)
          {
            const std::uint32_t r = ring[found[k]], first = std::uint32_t(bonds.size());
            for (; k < found.size() && ring[found[k]] == r; ++k)
              bonds.push_back(node[found[k]]);
            of_points[c].push_back(std::uint32_t(nears.size()));
            of_rings[r].push_back(std::uint32_t(nears.size()));
            nears.push_back({i, r, first, std::uint32_t(bonds.size()), fluid, 0.});
            Hit hit;
            nears.back().slack = distance(nears.back(), hit) - (fluid ? parameters.fluid_range : parameters.range);
          }
      }
}

void CellContact::update_ranges()
{
  if (!damage)
    return;
  const double most = parameters.fluid_range;
  auto near = nears.cbegin();
  for (std::size_t c = 0; c < groups.size(); ++c)
    if (broken_at_build[c] > 0)
      for (std::uint32_t i = groups[c].fluid; i < groups[c].end; ++i)
        {
          while (near != nears.end() && near->point < i)
            ++near;
          double free = most;
          for (; near != nears.end() && near->point == i; ++near)
            {
              Hit hit;
              free = std::min(free, distance(*near, hit));
            }
          fluid_range[i] = fluid_range[i] < 0. ? free : std::max(fluid_range[i], free);
        }
}

double CellContact::distance(const Near &near, Hit &hit) const
{
  const Group &g = groups[near.ring];
  const double *px = y[0].data(), *py = y[1].data();
  const double x = px[near.point], z = py[near.point];
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = near.first; k < near.last; ++k)
    {
      const std::uint32_t a = bonds[k], b = next_in(g, a);
      const double ex = px[b] - px[a], ey = py[b] - py[a], qx = x - px[a], qy = z - py[a];
      const double l2 = ex * ex + ey * ey, t = l2 > 0. ? std::clamp((qx * ex + qy * ey) / l2, 0., 1.) : 0.;
      const double rx = qx - t * ex, ry = qy - t * ey, r2 = rx * rx + ry * ry;
      if (r2 < least)
        {
          least = r2;
          hit.a = a;
          hit.b = b;
          hit.t = t;
          hit.force[0] = rx;
          hit.force[1] = ry;
        }
    }
  return std::sqrt(least);
}

CellContact::Hit CellContact::touch(const Near &near) const
{
  Hit hit;
  if (near.slack > 2. * moved)
    return hit;
  const double range = near.fluid ? fluid_range[near.point] : parameters.range, d = distance(near, hit);
  hit.overlap = d > 0. ? std::max(0., range - d) : 0.;
  const double push = hit.overlap > 0. ? parameters.stiffness * hit.overlap / d : 0.;
  hit.force[0] *= push;
  hit.force[1] *= push;
  return hit;
}

void CellContact::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group)
{
  const Group &g = particles.groups[group];
  std::vector<double> &on = on_face[group];
  std::fill(on.begin(), on.end(), 0.);
  for (const std::uint32_t n : of_points[group])
    {
      const Hit hit = touch(nears[n]);
      if (!(hit.overlap > 0.))
        continue;
      const std::uint32_t i = nears[n].point;
      for (int d = 0; d < 2; ++d)
        (nears[n].fluid ? particles.f[d][i] : on[2 * (i - g.begin) + d]) += hit.force[d];
    }
  for (const std::uint32_t n : of_rings[group])
    {
      const Hit hit = touch(nears[n]);
      if (!(hit.overlap > 0.))
        continue;
      for (int d = 0; d < 2; ++d)
        {
          on[2 * (hit.a - g.begin) + d] -= (1. - hit.t) * hit.force[d];
          on[2 * (hit.b - g.begin) + d] -= hit.t * hit.force[d];
        }
    }
  parameters.surface.push(particles, g, on.data());
}

double CellContact::energy(const Particles<2> &, const Box<2> &, const std::size_t group) const
{
  double total = 0.;
  for (const std::uint32_t n : of_points[group])
    {
      const double overlap = touch(nears[n]).overlap;
      total += 0.5 * parameters.stiffness * overlap * overlap;
    }
  return total;
}

double CellContact::deepest() const
{
  double most = 0.;
  for (const Near &near : nears)
    if (Hit hit; !near.fluid && near.slack <= 2. * moved)
      most = std::max(most, parameters.range - distance(near, hit));
  return most;
}

std::size_t CellContact::crossed_bonds() const
{
  const auto left = [&](const std::uint32_t a, const std::uint32_t b, const std::uint32_t p) {
    return (y[0][b] - y[0][a]) * (y[1][p] - y[1][a]) - (y[1][b] - y[1][a]) * (y[0][p] - y[0][a]) > 0.;
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossed;
  for (std::size_t c = 0; c < groups.size(); ++c)
    for (const std::uint32_t n : of_points[c])
      if (const Near &near = nears[n]; !near.fluid)
        for (const std::uint32_t a : {near.point, near.point > groups[c].begin ? near.point - 1 : groups[c].fluid - 1})
          for (std::uint32_t k = near.first; k < near.last; ++k)
            {
              const std::uint32_t b = next_in(groups[c], a), e = bonds[k], f = next_in(groups[near.ring], e);
              if ((damage && damage->cells[c].bond_broken[a - groups[c].begin]) || a == e || b == e || a == f)
                continue;
              if (left(a, b, e) != left(a, b, f) && left(e, f, a) != left(e, f, b))
                crossed.emplace(std::min(a, e), std::max(a, e));
            }
  return crossed.size();
}

Rates CellContact::rates(const Particles<2> &particles) const
{
  // A node held by a foreign bond, and two foreign nodes on either bond of its own: rows of at most 4 k; faces turn with their nodes.
  Rates bound;
  const double k = parameters.stiffness, lever = 1. + parameters.surface.inset / parameters.spacing;
  bound.wall.frequency_squared = 4. * k * lever * lever / parameters.node_mass;
  if (damage)
    for (const Group &g : particles.groups)
      if (g.fluid_count() > 0)
        bound.fluid.frequency_squared = std::max(bound.fluid.frequency_squared, 2. * k * particles.inverse_mass[g.fluid]);
  return bound;
}

void CellContact::archive(Archive &a, Particles<2> &particles)
{
  a.section("cell contact");
  a(origin, broken_at_build, fluid_range);
  if (!a.loading() || origin[0].empty())
    return;
  y = origin; // slack is that of the build
  build();
  place(particles, y);
  stale(); // how far everything has moved since
}
} // namespace turgor
