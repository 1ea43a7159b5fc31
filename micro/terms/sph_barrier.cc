#include "micro/terms/sph_barrier.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// Weights of a, b (and c) in the point of the face that is nearest to the origin.
Vector<2> nearest(const Vector<2> &a, const Vector<2> &b) {
  const Vector<2> e = b - a;
  const double t = std::clamp(-a.dot(e) / std::max(e.squaredNorm(), 1e-300), 0., 1.);
  return {1. - t, t};
}

Vector<3> nearest(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c) {
  const Vector<3> corners[3] = {a, b, c}, n = (b - a).cross(c - a);
  // Twice the signed areas of the foot of the perpendicular with the edges.
  const Vector<3> inside(n.dot(b.cross(c)), n.dot(c.cross(a)), n.dot(a.cross(b)));
  if (inside.minCoeff() >= 0. && n.squaredNorm() > 0.) return inside / n.squaredNorm();
  double least = HUGE_VAL;
  Vector<3> best = Vector<3>::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vector<3> &from = corners[k], edge = corners[(k + 1) % 3] - from;
    const double t = std::clamp(-from.dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0., 1.),
                 d = (from + t * edge).squaredNorm();
    if (d < least) {
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
double push_apart(Particles<dim> &p, const std::uint32_t particle, const std::uint32_t (&node)[dim],
                  const Vector<dim> (&corner)[dim], const double range, const double height) {
  Vector<dim> weights;
  if constexpr (dim == 2)
    weights = nearest(corner[0], corner[1]);
  else
    weights = nearest(corner[0], corner[1], corner[2]);
  Vector<dim> r = Vector<dim>::Zero();
  for (int k = 0; k < dim; ++k) r += weights[k] * corner[k];
  const double d = r.norm();
  if (!(d < range) || d == 0.) return 0.;
  const double missing = 1. - d / range;
  const Vector<dim> push = (2. * height * missing / (range * d)) * r;  // on the wall
  for (int a = 0; a < dim; ++a) {
    p.f[a][particle] -= push[a];
    for (int k = 0; k < dim; ++k) p.f[a][node[k]] += weights[k] * push[a];
  }
  return height * missing * missing;
}
}  // namespace

double add_barrier(const WallArcs &lists, Particles<2> &p, const Group &g, const double range,
                   const double height) {
  double energy = 0.;
  for (std::uint32_t i = 0; i < g.fluid_count(); ++i)
    for (std::uint32_t arc = lists.first_arc[i]; arc < lists.first_arc[i + 1]; ++arc)
      for (std::uint32_t k = 0; k < lists.arcs[arc].count; ++k) {
        const std::uint32_t a = (lists.arcs[arc].first + k) % g.wall_count(), b = (a + 1) % g.wall_count();
        const Vector<2> x = p.position(g.fluid + i), ra = p.position(g.begin + a) - x,
                        rb = p.position(g.begin + b) - x, e = rb - ra;
        const double area = ra[0] * rb[1] - ra[1] * rb[0];
        if (area * area < range * range * e.squaredNorm())  // the plane of the face is that near
          energy += push_apart<2>(p, g.fluid + i, {g.begin + a, g.begin + b}, {ra, rb}, range, height);
      }
  return energy;
}

double add_barrier(const WallFaces &lists, Particles<3> &p, const Group &g, const TriangleMesh &mesh,
                   const double range, const double height) {
  double energy = 0.;
  for (const sph::FaceList &list : lists.faces) {
    const auto &corner = mesh.faces[list.face];
    const std::uint32_t node[3] = {g.begin + corner[0], g.begin + corner[1], g.begin + corner[2]};
    const Vector<3> a = p.position(node[0]), b = p.position(node[1]), c = p.position(node[2]),
                    n = (b - a).cross(c - a);
    const double limit = range * range * n.squaredNorm();
    for (std::uint32_t k = 0; k < list.count[0]; ++k) {
      const std::uint32_t i = g.fluid + lists.particles[list.first + k];
      const Vector<3> x = p.position(i);
      const double volume = n.dot(a - x);
      if (volume * volume < limit)  // the plane of the face is that near
        energy += push_apart<3>(p, i, node, {a - x, b - x, c - x}, range, height);
    }
  }
  return energy;
}
}  // namespace turgor
