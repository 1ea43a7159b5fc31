#include "micro/terms/ring_wall.h"

#include <cmath>
#include <numbers>

namespace turgor
{
RingWall::RingWall(const NeoHookeanWall &law_, const double rest_length_, const double bending_stiffness,
                   const double spacing_, const unsigned int nodes_per_side_, const double node_mass_)
  : law(law_)
  , rest_length(rest_length_)
  , bending(bending_stiffness / spacing_)
  , spacing(spacing_)
  , nodes_per_side(nodes_per_side_)
  , node_mass(node_mass_)
{}

double RingWall::rest_angle(const std::uint32_t node) const
{
  return nodes_per_side > 0 && node % nodes_per_side == 0 ? std::numbers::pi / 2. : 0.;
}

void RingWall::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group)
{
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.wall_count();
  const double *x = particles.x[0].data() + g.begin, *y = particles.x[1].data() + g.begin;
  double *fx = particles.f[0].data() + g.begin, *fy = particles.f[1].data() + g.begin;
  const double inverse_rest = 1. / rest_length;

  // Edge k joins nodes k and k + 1; its gradient of energy is kept for both ends.
  const auto edge = [&](std::uint32_t k, double &ex, double &ey) {
    const std::uint32_t b = k + 1 < n ? k + 1 : 0;
    ex = x[b] - x[k];
    ey = y[b] - y[k];
  };
  double px, py;
  edge(n - 1, px, py);
  double previous2 = px * px + py * py;
  double gx_before = 0., gy_before = 0.; // dE/d(edge before)
  double last_gx = 0., last_gy = 0.; // what hinge 0 adds to the last edge
  for (std::uint32_t k = 0; k < n; ++k)
    {
      double ex, ey;
      edge(k, ex, ey);
      const double l2 = ex * ex + ey * ey, l = std::sqrt(l2);
      const double t = law.force(l * inverse_rest) / l;
      double gx = t * ex, gy = t * ey; // dE/d(edge)
      if (bending > 0.)
        {
          // hinge at node k between the edge before (p) and this one (e)
          const double theta = std::atan2(px * ey - py * ex, px * ex + py * ey);
          const double moment = bending * (theta - rest_angle(k));
          const double on_p = moment / previous2, on_e = moment / l2;
          const double hx = on_p * py, hy = -on_p * px; // -moment * perp(p)/|p|^2
          if (k == 0)
            {
              last_gx = hx;
              last_gy = hy;
            }
          else
            {
              gx_before += hx;
              gy_before += hy;
            }
          gx += -on_e * ey;
          gy += on_e * ex;
        }
      if (k > 0)
        {
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
    }
  gx_before += last_gx;
  gy_before += last_gy;
  fx[n - 1] += gx_before;
  fy[n - 1] += gy_before;
  fx[0] -= gx_before;
  fy[0] -= gy_before;
}

double RingWall::energy(const Particles<2> &particles, const Box<2> &, const std::size_t group) const
{
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.wall_count();
  const WallBending hinge{bending};
  double total = 0.;
  for (std::uint32_t k = 0; k < n; ++k)
    {
      const Vector<2> a = particles.position(g.begin + (k + n - 1) % n), b = particles.position(g.begin + k),
                      c = particles.position(g.begin + (k + 1) % n);
      total += rest_length * law.energy((c - b).norm() / rest_length);
      if (bending > 0.)
        total += hinge.energy(b - a, c - b, rest_angle(k));
    }
  return total;
}

Rates RingWall::rates(const Particles<2> &) const
{
  // Highest mode of a chain of masses: 2 sqrt(k/m) axially; 4 sqrt(B/(l^3 m)) in bending.
  Rates bound;
  bound.wall.frequency_squared = 4. * law.derivative(1.) / rest_length / node_mass
                                 + 16. * bending / (spacing * spacing * node_mass);
  return bound;
}
} // namespace turgor
