#include "micro/terms/ring_wall.h"

#include <algorithm>
#include <cmath>

namespace turgor {
RingWall::RingWall(const NeoHookeanWall &law, std::vector<RingShape> shapes_, const double spacing_,
                   const double node_mass_, const bool one_length_)
    : yielding_law(law),
      elastic_law(law.elastic()),
      shapes(std::move(shapes_)),
      spacing(spacing_),
      node_mass(node_mass_),
      shortest(spacing_),
      one_length(one_length_) {
  for (const RingShape &shape : shapes) {
    for (const double length : shape.rest_length)  // the shortest bond is the stiffest
      shortest = std::min(shortest, length);
    for (const double hinge : shape.hinge) stiffest_hinge = std::max(stiffest_hinge, hinge);
  }
}

double RingWall::rest(const std::size_t group, const std::size_t bond) const {
  const double length = shapes[group].rest_length[bond];
  return flow ? length * flow->permanent[group][bond] : length;
}

bool RingWall::broken(const std::size_t group, const std::size_t bond) const {
  return damage && damage->cells[group].bond_broken[bond];
}

std::size_t RingWall::bond_count(const Particles<2> &particles, const std::size_t group) const {
  return particles.groups[group].wall_count();
}

double RingWall::stretch(const Particles<2> &particles, const std::size_t group,
                         const std::size_t bond) const {
  const Group &g = particles.groups[group];
  const std::uint32_t a = g.begin + std::uint32_t(bond), b = a + 1 < g.fluid ? a + 1 : g.begin;
  return std::hypot(particles.x[0][b] - particles.x[0][a], particles.x[1][b] - particles.x[1][a]) /
         shapes[group].rest_length[bond];
}

double RingWall::bearable_stretch(const double stretch) const {
  return elastic_law.stretch_at(yielding_law.force(stretch));
}

double RingWall::tension(const Particles<2> &particles, const std::size_t group,
                         const std::size_t bond) const {
  if (broken(group, bond)) return 0.;
  const double lambda = stretch(particles, group, bond);
  return flow ? elastic_law.force(lambda / flow->permanent[group][bond]) : yielding_law.force(lambda);
}

void RingWall::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group) {
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.wall_count();
  const double *x = particles.x[0].data() + g.begin, *y = particles.x[1].data() + g.begin;
  double *fx = particles.f[0].data() + g.begin, *fy = particles.f[1].data() + g.begin;
  const double inverse_rest = 1. / shortest;
  const bool alike = one_length && !flow, bends = stiffest_hinge > 0.;
  const double *hinge = shapes[group].hinge.data(), *angle_at_rest = shapes[group].rest_angle.data();
  const NeoHookeanWall &law = flow ? elastic_law : yielding_law;

  // Edge k joins nodes k and k + 1; its gradient of energy is kept for both ends.
  const auto edge = [&](std::uint32_t k, double &ex, double &ey) {
    const std::uint32_t b = k + 1 < n ? k + 1 : 0;
    ex = x[b] - x[k];
    ey = y[b] - y[k];
  };
  double px, py;
  edge(n - 1, px, py);
  double previous2 = px * px + py * py;
  bool before_broken = broken(group, n - 1);
  double gx_before = 0., gy_before = 0.;  // dE/d(edge before)
  double last_gx = 0., last_gy = 0.;      // what hinge 0 adds to the last edge
  for (std::uint32_t k = 0; k < n; ++k) {
    double ex, ey;
    edge(k, ex, ey);
    const double l2 = ex * ex + ey * ey, l = std::sqrt(l2);
    const bool now_broken = damage && broken(group, k);
    const double t = now_broken ? 0. : law.force(alike ? l * inverse_rest : l / rest(group, k)) / l;
    double gx = t * ex, gy = t * ey;  // dE/d(edge)
    if (bends && !before_broken && !now_broken) {
      // hinge at node k between the edge before (p) and this one (e)
      const double theta = std::atan2(px * ey - py * ex, px * ex + py * ey);
      const double moment = hinge[k] * (theta - angle_at_rest[k]);
      const double on_p = moment / previous2, on_e = moment / l2;
      const double hx = on_p * py, hy = -on_p * px;  // -moment * perp(p)/|p|^2
      if (k == 0) {
        last_gx = hx;
        last_gy = hy;
      } else {
        gx_before += hx;
        gy_before += hy;
      }
      gx += -on_e * ey;
      gy += on_e * ex;
    }
    if (k > 0) {
      const std::uint32_t a = k - 1;
      fx[a] += gx_before;
      fy[a] += gy_before;
      fx[k] -= gx_before;
      fy[k] -= gy_before;
    }
    gx_before = gx;
    gy_before = gy;
    px = ex;
    py = ey;
    previous2 = l2;
    before_broken = now_broken;
  }
  gx_before += last_gx;
  gy_before += last_gy;
  fx[n - 1] += gx_before;
  fy[n - 1] += gy_before;
  fx[0] -= gx_before;
  fy[0] -= gy_before;
}

double RingWall::energy(const Particles<2> &particles, const Box<2> &, const std::size_t group) const {
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.wall_count();
  const NeoHookeanWall &law = flow ? elastic_law : yielding_law;
  double total = 0.;
  for (std::uint32_t k = 0; k < n; ++k) {
    const Vector<2> a = particles.position(g.begin + (k + n - 1) % n), b = particles.position(g.begin + k),
                    c = particles.position(g.begin + (k + 1) % n);
    if (broken(group, k)) continue;
    const double length = rest(group, k);
    total += length * law.energy((c - b).norm() / length);
    if (stiffest_hinge > 0. && !broken(group, (k + n - 1) % n))
      total += WallBending{shapes[group].hinge[k]}.energy(b - a, c - b, shapes[group].rest_angle[k]);
  }
  return total;
}

Rates RingWall::rates(const Particles<2> &) const {
  // Highest mode of a chain of masses: 2 sqrt(k/m) axially; 4 sqrt(B/(l^3 m)) in bending.
  Rates bound;
  bound.wall.frequency_squared = 4. * elastic_law.derivative(1.) / shortest / node_mass +
                                 16. * stiffest_hinge / (spacing * spacing * node_mass);
  return bound;
}
}  // namespace turgor
