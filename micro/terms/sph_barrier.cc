#include "micro/terms/sph_barrier.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace turgor
{
namespace
{
/// Weights of a, b (and c) in the point of the face that is nearest to the origin.
Vector<2> nearest(const Vector<2> &a, const Vector<2> &b)
{
  const Vector<2> e = b - a;
  const double t = std::clamp(-a.dot(e) / std::max(e.squaredNorm(), 1e-300), 0., 1.);
  return {1. - t, t};
}

Vector<3> nearest(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c)
{
  const Vector<3> corners[3] = {a, b, c}, n = (b - a).cross(c - a);
  // Twice the signed areas of the foot of the perpendicular with the edges.
  const Vector<3> inside(n.dot(b.cross(c)), n.dot(c.cross(a)), n.dot(a.cross(b)));
  if (inside.minCoeff() >= 0. && n.squaredNorm() > 0.)
    return inside / n.squaredNorm();
  double least = HUGE_VAL;
  Vector<3> best = Vector<3>::Zero();
  for (int k = 0; k < 3; ++k)
    {
      const Vector<3> &from = corners[k], edge = corners[(k + 1) % 3] - from;
      const double t = std::clamp(-from.dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0., 1.),
                   d = (from + t * edge).squaredNorm();
      if (d < least)
        {
          least = d;
          best.setZero();
          best[k] = 1. - t;
          best[(k + 1) % 3] = t;
        }
    }
  return best;
}

/// One particle and one face, whose corners are given from the particle. Returns the energy.
template <int dim>
double push_apart(Particles<dim> &p, const std::uint32_t particle, const std::uint32_t (&node)[dim], const Vector<dim> (&corner)[dim],
                  const double range, const double height)
{
  Vector<dim> weights;
  if constexpr (dim == 2)
    weights = nearest(corner[0], corner[1]);
  else
    weights = nearest(corner[0], corner[1], corner[2]);
  Vector<dim> r = Vector<dim>::Zero();
  for (int k = 0; k < dim; ++k)
    r += weights[k] * corner[k];
  const double d = r.norm();
  if (!(d < range) || d == 0.)
    return 0.;
  const double missing = 1. - d / range;
  const Vector<dim> push = (2. * height * missing / (range * d)) * r; // on the wall
  for (int a = 0; a < dim; ++a)
    {
      p.f[a][particle] -= push[a];
      for (int k = 0; k < dim; ++k)
        p.f[a][node[k]] += weights[k] * push[a];
    }
  return height * missing * missing;
}
} // namespace

double add_barrier(const WallArcs &lists, Particles<2> &p, const Group &g, const double range, const double height)
{
  double energy = 0.;
  for (std::uint32_t i = 0; i < g.fluid_count(); ++i)
    for (std::uint32_t arc = lists.first_arc[i]; arc < lists.first_arc[i + 1]; ++arc)
      for (std::uint32_t k = 0; k < lists.arcs[arc].count; ++k)
        {
          const std::uint32_t a = (lists.arcs[arc].first + k) % g.wall_count(), b = (a + 1) % g.wall_count();
          const Vector<2> x = p.position(g.fluid + i), ra = p.position(g.begin + a) - x, rb = p.position(g.begin + b) - x,
                          e = rb - ra;
          const double area = ra[0] * rb[1] - ra[1] * rb[0];
          if (area * area < range * range * e.squaredNorm()) // the plane of the face is that near
            energy += push_apart<2>(p, g.fluid + i, {g.begin + a, g.begin + b}, {ra, rb}, range, height);
        }
  return energy;
}

double add_barrier(const WallFans &lists, Particles<3> &p, const Group &g, const double range, const double height)
{
  double energy = 0.;
  for (std::uint32_t i = 0; i < g.fluid_count(); ++i)
    {
      const sph::Fan &fan = lists.fans[i];
      const Vector<3> x = p.position(g.fluid + i);
      for (std::uint32_t k = 0; k < fan.faces[0]; ++k)
        {
          std::uint32_t node[3];
          Vector<3> r[3];
          const std::uint16_t *corner = lists.corners.data() + fan.first_corner
                                        + (k / sph::list_padding) * 3 * sph::list_padding + k % sph::list_padding;
          for (int c = 0; c < 3; ++c)
            {
              node[c] = g.begin + lists.nodes[fan.first_node + corner[c * sph::list_padding]];
              r[c] = p.position(node[c]) - x;
            }
          const Vector<3> n = (r[1] - r[0]).cross(r[2] - r[0]);
          const double volume = n.dot(r[0]);
          if (volume * volume < range * range * n.squaredNorm()) // the plane of the face is that near
            energy += push_apart<3>(p, g.fluid + i, node, r, range, height);
        }
    }
  return energy;
}
} // namespace turgor
