#include "micro/terms/cell_contact.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace turgor {
CellContact::CellContact(const CellContactParameters &parameters_, std::shared_ptr<const WallDamage> damage_)
    : parameters(parameters_), damage(std::move(damage_)) {}

void CellContact::declare(Particles<2> &particles) {
  groups = particles.groups;
  of_points.assign(groups.size(), {});
  of_rings.assign(groups.size(), {});
  broken_at_build.assign(groups.size(), 0);
  on_face.clear();
  for (const Group &g : groups) on_face.emplace_back(2 * g.wall_count(), 0.);
  if (damage) fluid_range.assign(particles.size(), -1.);  // -1: not out yet
  y = particles.x;
}

std::uint32_t CellContact::points_end(const std::size_t group) const {
  return broken_at_build[group] > 0 ? groups[group].end : groups[group].fluid;
}

void CellContact::place(const Particles<2> &particles, Particles<2>::Components &at) const {
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const Group &g = groups[group];
    parameters.surface.place(particles, g, at);
    for (int d = 0; d < 2; ++d)
      std::copy(particles.x[d].begin() + g.fluid, particles.x[d].begin() + points_end(group),
                at[d].begin() + g.fluid);
  }
}

bool CellContact::stale() {
  if (origin[0].empty()) return true;
  if (damage)
    for (std::size_t group = 0; group < groups.size(); ++group)
      if (broken_at_build[group] != damage->cells[group].broken) return true;
  double most = 0.;
  bool wild = false;  // not a number
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (std::uint32_t i = groups[group].begin; i < points_end(group); ++i) {
      const double dx = y[0][i] - origin[0][i], dy = y[1][i] - origin[1][i], r2 = dx * dx + dy * dy;
      wild = wild || !(r2 < std::numeric_limits<double>::infinity());
      most = std::max(most, r2);
    }
  // an image moves with the periods as well
  const Tensor2<2> dH = box.H - box_at_build.H;
  moved = std::sqrt(most) + 0.5 * (most_shift[0] * dH.col(0).norm() + most_shift[1] * dH.col(1).norm());
  return wild || moved > 0.5 * parameters.skin;
}

void CellContact::prepare(const Particles<2> &particles, const Box<2> &now, unsigned int, bool) {
  box = now;
  place(particles, y);
  if (!stale()) return;
  if (damage) {
    for (std::size_t group = 0; group < groups.size(); ++group)
      broken_at_build[group] = damage->cells[group].broken;
    place(particles, y);  // fluid that is out now
  }
  origin = y;
  box_at_build = box;
  build();
  update_ranges();
  ++builds;
}

void CellContact::update_ranges() {
  if (!damage) return;
  const double most = parameters.fluid_range;
  auto near = nears.cbegin();
  for (std::size_t c = 0; c < groups.size(); ++c)
    if (broken_at_build[c] > 0)
      for (std::uint32_t i = groups[c].fluid; i < groups[c].end; ++i) {
        while (near != nears.end() && near->point < i) ++near;
        double free = most;
        for (; near != nears.end() && near->point == i; ++near) {
          Hit hit;
          free = std::min(free, distance(*near, hit));
        }
        fluid_range[i] = fluid_range[i] < 0. ? free : std::max(fluid_range[i], free);
      }
}

double CellContact::distance(const Near &near, Hit &hit) const {
  const Group &g = groups[near.ring];
  const double *px = y[0].data(), *py = y[1].data();
  const Vector<2> away = box.image(near.shift);
  const double x = px[near.point] - away[0], z = py[near.point] - away[1];
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = near.first; k < near.last; ++k) {
    const std::uint32_t a = bonds[k], b = wall_node_after(g, a);
    const double ex = px[b] - px[a], ey = py[b] - py[a], qx = x - px[a], qy = z - py[a];
    const double l2 = ex * ex + ey * ey, t = l2 > 0. ? std::clamp((qx * ex + qy * ey) / l2, 0., 1.) : 0.;
    const double rx = qx - t * ex, ry = qy - t * ey, r2 = rx * rx + ry * ry;
    if (r2 < least) {
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

CellContact::Hit CellContact::touch(const Near &near) const {
  Hit hit;
  if (near.slack > 2. * moved) return hit;
  const double range = near.fluid ? fluid_range[near.point] : parameters.range, d = distance(near, hit);
  hit.overlap = d > 0. ? std::max(0., range - d) : 0.;
  const double push = hit.overlap > 0. ? parameters.push(hit.overlap, near.fluid) / d : 0.;
  hit.force[0] *= push;
  hit.force[1] *= push;
  return hit;
}

void CellContact::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group) {
  const Group &g = particles.groups[group];
  std::vector<double> &on = on_face[group];
  std::fill(on.begin(), on.end(), 0.);
  for (const std::uint32_t n : of_points[group]) {
    const Hit hit = touch(nears[n]);
    if (!(hit.overlap > 0.)) continue;
    const std::uint32_t i = nears[n].point;
    for (int d = 0; d < 2; ++d)
      (nears[n].fluid ? particles.f[d][i] : on[2 * (i - g.begin) + d]) += hit.force[d];
  }
  for (const std::uint32_t n : of_rings[group]) {
    const Hit hit = touch(nears[n]);
    if (!(hit.overlap > 0.)) continue;
    for (int d = 0; d < 2; ++d) {
      on[2 * (hit.a - g.begin) + d] -= (1. - hit.t) * hit.force[d];
      on[2 * (hit.b - g.begin) + d] -= hit.t * hit.force[d];
    }
  }
  parameters.surface.push(particles, g, on.data());
}

double CellContact::energy(const Particles<2> &, const Box<2> &, const std::size_t group) const {
  double total = 0.;
  for (const std::uint32_t n : of_points[group])
    total += parameters.energy(touch(nears[n]).overlap, nears[n].fluid);
  return total;
}

Tensor2<2> CellContact::image_virial(const Particles<2> &, const Box<2> &, const std::size_t group) const {
  Tensor2<2> total = Tensor2<2>::Zero();
  for (const auto *entries : {&of_points[group], &of_rings[group]})
    for (const std::uint32_t n : *entries)
      if (nears[n].shift != std::array<int, 2>{}) {
        const Hit hit = touch(nears[n]);
        if (hit.overlap > 0.)
          total += 0.5 * Vector<2>(hit.force[0], hit.force[1]) * box.image(nears[n].shift).transpose();
      }
  return total;
}

double CellContact::deepest() const {
  double most = 0.;
  for (const Near &near : nears)
    if (Hit hit; !near.fluid && near.slack <= 2. * moved)
      most = std::max(most, parameters.range - distance(near, hit));
  return most;
}

std::size_t CellContact::crossed_bonds() const {
  // p and its ring are moved by `away` against the bond from a to b
  const auto left = [&](const std::uint32_t a, const std::uint32_t b, const std::uint32_t p,
                        const Vector<2> &away) {
    return (y[0][b] - y[0][a]) * (y[1][p] + away[1] - y[1][a]) -
               (y[1][b] - y[1][a]) * (y[0][p] + away[0] - y[0][a]) >
           0.;
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossed;
  for (std::size_t c = 0; c < groups.size(); ++c)
    for (const std::uint32_t n : of_points[c])
      if (const Near &near = nears[n]; !near.fluid)
        for (const std::uint32_t a :
             {near.point, near.point > groups[c].begin ? near.point - 1 : groups[c].fluid - 1})
          for (std::uint32_t k = near.first; k < near.last; ++k) {
            const std::uint32_t b = wall_node_after(groups[c], a), e = bonds[k],
                                f = wall_node_after(groups[near.ring], e);
            const bool same_ring = near.shift == std::array<int, 2>{};
            if ((damage && damage->cells[c].bond_broken[a - groups[c].begin]) ||
                (same_ring && (a == e || b == e || a == f)))
              continue;
            const Vector<2> away = box.image(near.shift);
            if (left(a, b, e, away) != left(a, b, f, away) && left(e, f, a, -away) != left(e, f, b, -away))
              crossed.emplace(std::min(a, e), std::max(a, e));
          }
  return crossed.size();
}

Rates CellContact::rates(const Particles<2> &particles) const {
  // A node held by a foreign bond, and two foreign nodes on either bond of its own: rows of at most 4 k;
  // faces turn with their nodes.
  Rates bound;
  const double k = parameters.stiffness, lever = 1. + parameters.surface.inset / parameters.spacing;
  bound.wall.frequency_squared = 4. * parameters.steepest() * lever * lever / parameters.node_mass;
  if (damage)
    for (const Group &g : particles.groups)
      if (g.fluid_count() > 0)
        bound.fluid.frequency_squared =
            std::max(bound.fluid.frequency_squared, 2. * k * particles.inverse_mass[g.fluid]);
  return bound;
}

void CellContact::archive(Archive &a, Particles<2> &particles) {
  a.section("cell contact");
  a(origin, box.periodic, box.H, box_at_build.H, broken_at_build, fluid_range);
  if (!a.loading() || origin[0].empty()) return;
  box_at_build.periodic = box.periodic;
  const Box<2> now = box;
  box = box_at_build;  // slack is that of the build
  y = origin;
  build();
  box = now;
  place(particles, y);
  stale();  // how far everything has moved since
}
}  // namespace turgor
