// What the ring of a 2D cell adds to the fluid's viscosity (sph_viscosity.inc.h): rays to two points of every
// face in reach, lane = face. Included by sph_sweeps.inc.h alone and under its rule: anonymous namespace, no
// inline function of a shared header.
//
// Halving the angle under which a face is seen, and each half again, needs no angle: the bisector of a and b
// meets the face at |b|/(|a| + |b|) of a and the rest of b. Each of the two points so found stands for half
// of the face's angle:
//   w = (2 N(s)/s) (angle/2) min(1, z/z_0),  z the distance to the face's line,
//   2 N/s = 280/(pi R^2) v^4 (1/4 - 2 v/5 + v^2/6)/u,  u = s/R, v = 1 - u          (W' of the ordinary
//     kernel)
// The velocity at the wall is so continued along the ray to the rim of the kernel; weights along it sum up to
// N. A uniform gradient then leaves no net force on any particle. Faces seen from behind (z < 0) count
// nothing.
#pragma once

#include "micro/terms/sph_viscosity.inc.h"
#include "micro/terms/sph_wall_edges.inc.h"

namespace turgor::sph {
namespace {
/// What a particle's rays to a face come to: sum over the points q of w_q b_qk b_ql, b_q the shares of the
/// face's two nodes. All else follows: S = sum_kl of it a_k (x) a_l with the nodes' places a_k from the
/// particle, and so on.
struct Rays {
  V own, both, next;
};

/// Its two points: where they are, from a to b, and their weights.
inline void points_of_face(const CellView<2> &c, const V a[2], const V b[2], const V live, V place[2],
                           V weight[2]) {
  const double R = c.support;
  const V zero = splat(0.), one = splat(1.), iR = splat(1. / R), tiny = splat(1e-24 * R * R);
  const V ex = b[0] - a[0], ey = b[1] - a[1], cross = a[0] * b[1] - a[1] * b[0],
          z = cross * rsqrt(ex * ex + ey * ey + tiny);
  const V la = root(a[0] * a[0] + a[1] * a[1] + tiny), lb = root(b[0] * b[0] + b[1] * b[1] + tiny),
          middle = la * reciprocal(la + lb);
  const V mx = a[0] + middle * ex, my = a[1] + middle * ey, lm = root(mx * mx + my * my + tiny);
  // 140/(pi R^2) for half of the angle
  const V scale = live * splat(140. / (pi * R * R)) * angle(cross, a[0] * b[0] + a[1] * b[1]) *
                  lesser(one, positive(z) * splat(1. / (viscous_reach * R)));
  place[0] = middle * la * reciprocal(la + lm);
  place[1] = middle + (one - middle) * lm * reciprocal(lm + lb);
  for (int q = 0; q < 2; ++q) {
    const V t = place[q], rx = a[0] + t * ex, ry = a[1] + t * ey, u = root(rx * rx + ry * ry + tiny) * iR,
            v = positive(one - u), v2 = v * v;
    const V profile = v2 * v2 * (splat(1. / 4.) - v * (splat(2. / 5.) - v * splat(1. / 6.)));
    weight[q] = select_less(zero, z, scale * profile * reciprocal(u), zero);
  }
}

inline Rays rays_to_face(const CellView<2> &c, const V a[2], const V b[2], const V live) {
  V place[2], weight[2];
  points_of_face(c, a, b, live, place, weight);
  Rays rays{splat(0.), splat(0.), splat(0.)};
  for (int q = 0; q < 2; ++q) {
    const V t = place[q], to_b = weight[q] * t;
    rays.next += to_b * t;
    rays.both += to_b - to_b * t;
    rays.own += weight[q] - to_b - (to_b - to_b * t);
  }
  return rays;
}

/// The points for those who multiply by themselves.
void wall_rays(CellView<2> &c) {
  double *to = c.ray_points;
  for (std::uint32_t i = 0; i < c.n; ++i)
    for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc)
      for (std::uint32_t k = 0; k < c.arcs[arc].count; k += W) {
        const std::uint32_t at = c.arcs[arc].first + k, live = c.arcs[arc].count - k;
        V a[2], b[2], place[2], weight[2];
        for (int d = 0; d < 2; ++d) {
          a[d] = load(c.wall_x[d] + at) - splat(c.x[d][i]);
          b[d] = load(c.wall_x[d] + at + 1) - splat(c.x[d][i]);
        }
        points_of_face(c, a, b, first_lanes(live), place, weight);
        for (std::uint32_t l = 0; l < W && l < live; ++l, to += ray_doubles)
          for (int q = 0; q < 2; ++q) {
            to[2 * q] = place[q][l];
            to[2 * q + 1] = weight[q][l];
          }
      }
}

/// Calls body(first node, places and velocities of both nodes from the particle, lanes in use) for the faces
/// in reach of particle i.
template <typename Body>
inline void for_faces(const CellView<2> &c, const std::uint32_t i, const Body &body) {
  const V x[2] = {splat(c.x[0][i]), splat(c.x[1][i])}, v[2] = {splat(c.v[0][i]), splat(c.v[1][i])};
  for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc)
    for (std::uint32_t k = 0; k < c.arcs[arc].count; k += W) {
      const std::uint32_t at = c.arcs[arc].first + k;
      V a[2], b[2], va[2], vb[2];
      for (int d = 0; d < 2; ++d) {
        a[d] = load(c.wall_x[d] + at) - x[d];
        b[d] = load(c.wall_x[d] + at + 1) - x[d];
        va[d] = load(c.wall_v[d] + at) - v[d];
        vb[d] = load(c.wall_v[d] + at + 1) - v[d];
      }
      body(at, a, b, va, vb, first_lanes(c.arcs[arc].count - k));
    }
}

/// Adds what the wall gives to S and Y; keeps the rays.
void add_wall_moments(CellView<2> &c) {
  Rays *kept = reinterpret_cast<Rays *>(c.scratch);
  for (std::uint32_t i = 0; i < c.n; ++i) {
    if (c.first_arc[i] == c.first_arc[i + 1]) continue;
    V total[8];
    for (V &sum : total) sum = splat(0.);
    for_faces(c, i,
              [&](std::uint32_t, const V a[2], const V b[2], const V va[2], const V vb[2], const V live) {
                const Rays rays = *kept++ = rays_to_face(c, a, b, live);
                V ra[2], rb[2];
                for (int d = 0; d < 2; ++d) {
                  ra[d] = rays.own * a[d] + rays.both * b[d];
                  rb[d] = rays.both * a[d] + rays.next * b[d];
                }
                total[0] += ra[0] * a[0] + rb[0] * b[0];
                total[1] += ra[0] * a[1] + rb[0] * b[1];
                total[2] += ra[1] * a[1] + rb[1] * b[1];
                for (int d = 0; d < 2; ++d)
                  for (int e = 0; e < 2; ++e) total[3 + 2 * d + e] += va[d] * ra[e] + vb[d] * rb[e];
              });
    double sums[8], *to = c.moments + 8 * std::size_t(i);
    sums_of_eight(total, sums);
    for (int k = 0; k < 8; ++k) to[k] += sums[k];
  }
}

/// The forces between particles and wall.
void drag_wall(CellView<2> &c, const bool thin) {
  const Rays *kept = reinterpret_cast<const Rays *>(c.scratch);
  const V scale = splat(c.viscosity * c.particle_volume), zero = splat(0.);
  for (std::uint32_t i = 0; i < c.n; ++i) {
    if (c.first_arc[i] == c.first_arc[i + 1]) continue;
    const double *T = c.viscous_rows + 8 * std::size_t(i) + Viscous<2>::tensor;
    const double share = thin ? c.moments[8 * std::size_t(i) + Viscous<2>::thin] : 0.;
    const V beta = splat(residual_share * (1. - share));
    V total[2] = {splat(0.), splat(0.)};
    for_faces(c, i, [&](const std::uint32_t at, const V a[2], const V b[2], const V va[2], const V vb[2], V) {
      const Rays rays = *kept++;
      V central[2][2] = {{zero, zero}, {zero, zero}};
      if (share > 0.) {
        const V m[3] = {rays.own, rays.both, rays.next}, r[2][2] = {{a[0], a[1]}, {b[0], b[1]}},
                v[2][2] = {{va[0], va[1]}, {vb[0], vb[1]}};
        drag_thin_rays<2>(c, m, r, v, central);
      }
      for (int d = 0; d < 2; ++d) {
        const V Tx = splat(T[2 * d]), Ty = splat(T[2 * d + 1]);
        const V ga = beta * va[d] + Tx * a[0] + Ty * a[1], gb = beta * vb[d] + Tx * b[0] + Ty * b[1];
        const V fa = scale * (rays.own * ga + rays.both * gb + splat(share) * central[0][d]),
                fb = scale * (rays.both * ga + rays.next * gb + splat(share) * central[1][d]);
        store(c.wall_f[d] + at, load(c.wall_f[d] + at) - fa);
        store(c.wall_f_next[d] + at, load(c.wall_f_next[d] + at) - fb);
        total[d] += fa + fb;
      }
    });
    double f[2];
    sums<2>(total, f);
    c.f[0][i] += f[0];
    c.f[1][i] += f[1];
  }
}
}  // namespace
}  // namespace turgor::sph
