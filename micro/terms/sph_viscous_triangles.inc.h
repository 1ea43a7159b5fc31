// What the triangles of a 3D cell add to the fluid's viscosity (sph_viscosity.inc.h): rays to points of every
// face in reach, face by face, lane = particle, all lengths over the support. Included by sph_sweeps.inc.h
// alone and under its rule: anonymous namespace, no inline function of a shared header.
//
// A triangle a, b, c seen from the particle takes up the solid angle O, tan(O/2) = a.(b x c) / (|a||b||c| +
// a.b|c| + b.c|a| + c.a|b|); the sum of the three directions meets it where the shares of its corners are as
// 1/|a|, 1/|b|, 1/|c|: the one point that stands for it. A face that is near (quadrature 0) is cut into four
// at the middles of its sides first.
//   w = (2 N(s)/s) O min(1, z/z_0),   2 N/s = 420/(pi R^2) v^4 (1/4 - 3 v/5 + v^2/2 - v^3/7)/u,   u = s/R, v
//                                     = 1 - u
#pragma once

#include "micro/terms/sph_viscosity.inc.h"
#include "micro/terms/sph_wall_triangles.inc.h"

namespace turgor::sph {
namespace {
/// Sum over the points q of w_q b_qk b_ql, b_q the shares of the face's corners: 00 01 02 11 12 22.
constexpr int rays_of_face = 6;

/// Adds the point of one triangle, whose corners have these shares of the face's corners. factor: of the
/// whole plane.
inline void add_ray(const Vec corner[3], const V length[3], const double (&shares)[3][3], const V factor,
                    V rays[rays_of_face]) {
  const V one = splat(1.), tiny = splat(1e-24);
  const Vec &a = corner[0], &b = corner[1], &e = corner[2];
  const V la = length[0], lb = length[1], le = length[2];
  const V volume = dot(a, cross(b, e)),
          plain = la * lb * le + dot(a, b) * le + dot(b, e) * la + dot(e, a) * lb;
  const V pa = lb * le, pb = le * la, pe = la * lb, over = reciprocal(pa + pb + pe + tiny);
  const V part[3] = {pa * over, pb * over, pe * over};
  const Vec r{part[0] * a.x + part[1] * b.x + part[2] * e.x, part[0] * a.y + part[1] * b.y + part[2] * e.y,
              part[0] * a.z + part[1] * b.z + part[2] * e.z};
  const V u = root(dot(r, r) + tiny), v = positive(one - u), v2 = v * v;
  const V profile =
      v2 * v2 * (splat(1. / 4.) - v * (splat(3. / 5.) - v * (splat(1. / 2.) - v * splat(1. / 7.))));
  const V weight = factor * profile * reciprocal(u) * splat(2.) * angle(volume, plain);
  V share[3];
  for (int k = 0; k < 3; ++k)
    share[k] = part[0] * splat(shares[0][k]) + part[1] * splat(shares[1][k]) + part[2] * splat(shares[2][k]);
  for (int k = 0, at = 0; k < 3; ++k)
    for (int l = k; l < 3; ++l, ++at) rays[at] += weight * share[k] * share[l];
}

/// r: the face's corners from W particles. False, with no rays, where all are out of reach.
template <bool near>
inline bool rays_to_face(const CellView<3> &c, const Vec r[3], const V live, V rays[rays_of_face]) {
  const V zero = splat(0.), one = splat(1.), tiny = splat(1e-24);
  for (int k = 0; k < rays_of_face; ++k) rays[k] = zero;
  const Vec ab{r[1].x - r[0].x, r[1].y - r[0].y, r[1].z - r[0].z},
      ac{r[2].x - r[0].x, r[2].y - r[0].y, r[2].z - r[0].z}, n = cross(ab, ac);
  const V z = dot(n, r[0]) * rsqrt(dot(n, n) + tiny);
  const V factor = select_less(
      zero, z, live * splat(420. / (pi * c.support * c.support)) * lesser(one, z * splat(1. / viscous_reach)),
      zero);
  if (!any_less(zero, factor) || !any_less(z, one)) return false;
  V length[3];
  for (int k = 0; k < 3; ++k) length[k] = root(dot(r[k], r[k]) + tiny);
  if constexpr (!near) {
    constexpr double whole[3][3] = {{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}};
    add_ray(r, length, whole, factor, rays);
  } else {
    Vec middle[3];  // of the sides opposite to the corners
    V far[3];
    for (int k = 0; k < 3; ++k) {
      const Vec &p = r[(k + 1) % 3], &q = r[(k + 2) % 3];
      const V half = splat(0.5);
      middle[k] = {half * (p.x + q.x), half * (p.y + q.y), half * (p.z + q.z)};
      far[k] = root(dot(middle[k], middle[k]) + tiny);
    }
    constexpr double inner[3][3] = {{0., .5, .5}, {.5, 0., .5}, {.5, .5, 0.}};
    add_ray(middle, far, inner, factor, rays);
    constexpr double outer[3][3][3] = {{{1., 0., 0.}, {.5, .5, 0.}, {.5, 0., .5}},
                                       {{0., 1., 0.}, {0., .5, .5}, {.5, .5, 0.}},
                                       {{0., 0., 1.}, {.5, 0., .5}, {0., .5, .5}}};
    for (int k = 0; k < 3; ++k) {
      const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      const Vec corner[3] = {r[k], middle[k2], middle[k1]};
      const V lengths[3] = {length[k], far[k2], far[k1]};
      add_ray(corner, lengths, outer[k], factor, rays);
    }
  }
  return true;
}

/// A face's corners: places (m) and velocities, all lanes alike.
struct MovingFace {
  V x[3][3], v[3][3];
};

inline void look_at(const CellView<3> &c, const std::uint32_t number, MovingFace &face) {
  const std::uint16_t *node = c.corners + 3 * std::size_t(number);
  for (int k = 0; k < 3; ++k)
    for (int d = 0; d < 3; ++d) {
      face.x[k][d] = splat(c.wall_x[4 * std::uint32_t(node[k]) + d]);
      face.v[k][d] = splat(c.wall_v[4 * std::uint32_t(node[k]) + d]);
    }
}

/// Calls body(near, face, list entries, lanes in use, place in the kept rays) for all chunks of W particles,
/// after(face) after each face.
template <typename Body, typename After>
inline void for_face_chunks(CellView<3> &c, const Body &body, const After &after) {
  double *kept = c.kept_rays;
  MovingFace face;
  for (std::uint32_t f = 0; f < c.n_faces; ++f) {
    const FaceList &list = c.face_lists[f];
    const std::uint16_t *j = c.face_particles + list.first;
    look_at(c, list.face, face);
    for (int q = 0; q < quadratures; ++q) {
      const std::uint32_t count = list.count[q];
      for (std::uint32_t k = 0; k < count; k += W, kept += rays_of_face * W)
        body(q == 0, face, j + k, first_lanes(count - k), kept);
      j += (count + list_padding - 1) / list_padding * list_padding;
    }
    after(list.face, face);
  }
}

/// Corners and their velocities from W particles, whose rows are given; places in m.
inline void from_particles(const MovingFace &face, const V own[8], V r[3][3], V v[3][3]) {
  for (int k = 0; k < 3; ++k)
    for (int d = 0; d < 3; ++d) {
      r[k][d] = face.x[k][d] - own[d];
      v[k][d] = face.v[k][d] - own[3 + d];
    }
}

/// Adds what the wall gives to S and Y; keeps the rays.
void add_wall_moments(CellView<3> &c) {
  constexpr int size = Viscous<3>::row;
  const V iR = splat(1. / c.support);
  const auto chunk = [&](const bool near, const MovingFace &face, const std::uint16_t *j, const V live,
                         double *kept) {
    V own[8], r[3][3], v[3][3], rays[rays_of_face];
    load_rows<size>(c.viscous_rows, j, own);
    from_particles(face, own, r, v);
    Vec corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = {iR * r[k][0], iR * r[k][1], iR * r[k][2]};
    const bool any =
        near ? rays_to_face<true>(c, corner, live, rays) : rays_to_face<false>(c, corner, live, rays);
    for (int k = 0; k < rays_of_face; ++k) store(kept + k * W, rays[k]);
    if (!any) return;
    V total[size];
    for (V &sum : total) sum = splat(0.);
    constexpr int at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    for (int k = 0; k < 3; ++k) {
      V wr[3];
      for (int d = 0; d < 3; ++d)
        wr[d] = rays[at[k][0]] * r[0][d] + rays[at[k][1]] * r[1][d] + rays[at[k][2]] * r[2][d];
      int to = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b, ++to) total[to] += wr[a] * r[k][b];
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b, ++to) total[to] += v[k][a] * wr[b];
    }
    for (int part = 0; part < size; part += 4) add_to_rows<size>(c.moments + part, j, total + part);
  };
  for_face_chunks(c, chunk, [](std::uint32_t, const MovingFace &) {});
}

/// The forces between particles and wall.
void drag_wall(CellView<3> &c, const bool thin) {
  constexpr int size = Viscous<3>::row;
  const V scale = splat(c.viscosity * c.particle_volume), zero = splat(0.);
  for (std::uint32_t i = 0; i <= c.n; ++i) store_row(c.own + 4 * std::size_t(i), splat_row(0.));
  V on_corner[3][3];
  for (auto &corner : on_corner)
    for (V &f : corner) f = splat(0.);
  const auto chunk = [&](bool, const MovingFace &face, const std::uint16_t *j, V, const double *kept) {
    V rays[rays_of_face];
    for (int k = 0; k < rays_of_face; ++k) rays[k] = scale * load(kept + k * W);
    if (!any_less(splat(0.), rays[0] + rays[3] + rays[5])) return;
    V own[size], r[3][3], v[3][3], total[4];
    load_rows<size>(c.viscous_rows, j, own);
    load_rows<size>(c.viscous_rows + 8, j, own + 8);
    from_particles(face, own, r, v);
    total[3] = zero;
    V beta = splat(residual_share), share = zero,
      central[3][3] = {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
    if (thin) {
      V moments[8];
      load_rows<size>(c.moments + 8, j, moments);
      share = moments[Viscous<3>::thin - 8];
      if (any_less(zero, share)) {
        beta = beta * (splat(1.) - share);
        drag_thin_rays<3>(c, rays, r, v, central);
      }
    }
    for (int d = 0; d < 3; ++d) {
      const V *T = own + Viscous<3>::tensor + 3 * d;
      V g[3];
      for (int k = 0; k < 3; ++k) g[k] = beta * v[k][d] + T[0] * r[k][0] + T[1] * r[k][1] + T[2] * r[k][2];
      const V f0 = rays[0] * g[0] + rays[1] * g[1] + rays[2] * g[2] + share * central[0][d],
              f1 = rays[1] * g[0] + rays[3] * g[1] + rays[4] * g[2] + share * central[1][d],
              f2 = rays[2] * g[0] + rays[4] * g[1] + rays[5] * g[2] + share * central[2][d];
      on_corner[0][d] -= f0;
      on_corner[1][d] -= f1;
      on_corner[2][d] -= f2;
      total[d] = f0 + f1 + f2;
    }
    add_to_rows<4>(c.own, j, total);
  };
  for_face_chunks(c, chunk, [&](const std::uint32_t number, const MovingFace &) {
    for (int k = 0; k < 3; ++k) {
      double *force = c.wall_f + 4 * std::uint32_t(c.corners[3 * std::size_t(number) + k]), f[3];
      sums<3>(on_corner[k], f);
      for (int d = 0; d < 3; ++d) {
        force[d] += f[d];
        on_corner[k][d] = splat(0.);
      }
    }
  });
  for (std::uint32_t i = 0; i < c.n; ++i)
    for (int d = 0; d < 3; ++d) c.f[d][i] += c.own[4 * std::size_t(i) + d];
}
}  // namespace
}  // namespace turgor::sph
