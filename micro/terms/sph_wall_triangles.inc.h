// The wall's part of the sweeps of sph_sweeps.h in 3D: face by face, lane = particle, all lengths over the
// support R and from the face's centroid. Included by sph_sweeps.inc.h alone and under its rule: anonymous
// namespace, no inline function of a shared header.
//
// A face with corners y_k, n = (y_1 - y_0) x (y_2 - y_0) (twice its area), Gauss points y_g = sum_k l_gk y_k
// and weights w_g gives to the particle at x, with r_g = y_g - x, N = n . r (any point of the face), in units
// of 1/(8 pi):
//   integral G r.n dS  = N S,   S = sum_g w_g g(|r_g|),  g = 4 pi R^3 G = 14 - 84 u^2 + 140 u^3 - 90 u^4 + 21
//                      u^5 (u < 1)
//     and minus twice the angle, which all near faces of a particle have together (sph_wall_rims.inc.h)
//   integral D r.n dS  = N S with  g = -(1 - u)^5 (1 + 5 u + 15 u^2 + 21 u^3) / u^3   (both: ordinary kernel;
//                      sph_kernels.inc.h)
//   d (N S) / d y_k    = S (y_k+1 - x) x (y_k+2 - x) + sum_g l_gk K_g r_g,   K_g = N w_g (1/u) dg/du
// |r_g|^2 comes from |x|^2 and the three products x.y_k: no Gauss point has coordinates.
// S and the K_g are kept: when the push P of every particle is known, what the face's corners feel follows
// from the sums of P S, P S x, P K_g, P K_g x over the particles alone. The quadratures:
// sph_wall_quadrature.inc.h.
#pragma once

#include "micro/terms/sph_wall_quadrature.inc.h"
#include "micro/terms/sph_wall_rims.inc.h"

namespace turgor::sph {
namespace {
/// One face, all lanes alike; from its middle, over the support.
struct Face {
  double middle[4], corner[3][3];
  Vec middles, at[3], n;
  V square[3];  ///< of the corners' distances
};

inline void look_at(const CellView<3> &c, const std::uint32_t number, Face &face) {
  const double iR = 1. / c.support;
  const std::uint16_t *node = c.corners + 3 * std::size_t(number);
  for (int d = 0; d < 3; ++d) {
    double y[3];
    for (int k = 0; k < 3; ++k) y[k] = (c.wall_x[4 * std::uint32_t(node[k]) + d] - c.wall_x[d]) * iR;
    face.middle[d] = (y[0] + y[1] + y[2]) * (1. / 3.);
    for (int k = 0; k < 3; ++k) face.corner[k][d] = y[k] - face.middle[d];
  }
}

inline void prepare(const CellView<3> &c, const std::uint32_t number, Face &face) {
  look_at(c, number, face);
  face.middles = splat(face.middle);
  for (int k = 0; k < 3; ++k) {
    face.at[k] = splat(face.corner[k]);
    face.square[k] = dot(face.at[k], face.at[k]);
  }
  const Vec &a = face.at[0], &b = face.at[1], &e = face.at[2];
  face.n = cross({b.x - a.x, b.y - a.y, b.z - a.z}, {e.x - a.x, e.y - a.y, e.z - a.z});
}

/// W particles; false, and nothing done, where all are out of the support.
template <int quadrature, bool fourth_order>
inline bool see_face(CellView<3> &c, const Face &face, const std::uint16_t *j, const V live, double *kept) {
  constexpr int points = quadrature_points[quadrature];
  V own[4];
  load_half_rows<4>(c.own, j, own);
  const Vec p{own[0] - face.middles.x, own[1] - face.middles.y, own[2] - face.middles.z};
  const V one = splat(1.), tiny = splat(1e-24), pp = dot(p, p);
  V r2[points], value[points], slope[points];
  if constexpr (points == 1)
    r2[0] = greater(pp, tiny);
  else
    for (int k = 0; k < 3; ++k) {
      const V across = dot(p, face.at[k]);
      for (int o = 0; o < points / 3; ++o) {
        const double delta = orbits[quadrature][o].delta();
        r2[3 * o + k] =
            greater(pp + splat(delta * delta) * face.square[k] - splat(2. * delta) * across, tiny);
      }
    }
  if constexpr (quadrature == 0) {
    V most = r2[0];
    for (int g = 1; g < points; ++g) most = greater(most, r2[g]);
    if (any_less(one, most))
      for (int g = 0; g < points; ++g) profile_g<false, fourth_order>(r2[g], value[g], slope[g]);
    else
      for (int g = 0; g < points; ++g) profile_g<true, fourth_order>(r2[g], value[g], slope[g]);
  } else {
    V least = r2[0];
    for (int g = 1; g < points; ++g) least = lesser(least, r2[g]);
    if (!any_less(least, one)) return false;
    for (int g = 0; g < points; ++g) profile_d<fourth_order>(r2[g], value[g], slope[g]);
  }
  const V N = -dot(face.n, p);
  V S, all = splat(0.),
       shift[3] = {splat(0.), splat(0.), splat(0.)};  // shift: sum of delta K over the points of a corner
  if constexpr (points == 1)
    S = value[0];
  else {
    S = splat(orbits[quadrature][0].w) * (value[0] + value[1] + value[2]);
    if constexpr (points == 6) S += splat(orbits[quadrature][1].w) * (value[3] + value[4] + value[5]);
  }
  S = live * S;
  store(kept, S);
  for (int o = 0; o < (points + 2) / 3; ++o) {
    const V weight = live * N * splat(orbits[quadrature][o].w);
    for (int k = 0; k < 3 && 3 * o + k < points; ++k) {
      const V K = weight * slope[3 * o + k];
      store(kept + (3 * o + k + 1) * W, K);
      all += K;
      if constexpr (points > 1) shift[k] += splat(orbits[quadrature][o].delta()) * K;
    }
  }
  V pull[4] = {N * S, S * face.n.x - all * p.x, S * face.n.y - all * p.y, S * face.n.z - all * p.z};
  if constexpr (points > 1)
    for (int k = 0; k < 3; ++k) {
      pull[1] += shift[k] * face.at[k].x;
      pull[2] += shift[k] * face.at[k].y;
      pull[3] += shift[k] * face.at[k].z;
    }
  add_to_rows(c.pull, j, pull);
  return true;
}

template <int quadrature, bool fourth_order>
inline void see_face_all(CellView<3> &c, const Face &face, const std::uint32_t count, const std::uint16_t *&j,
                         double *&kept, std::uint16_t &active) {
  constexpr int size = (1 + quadrature_points[quadrature]) * W;
  std::uint32_t used = 0;
  for (std::uint32_t k = 0, chunk = 0; k < count; k += W, ++chunk)
    if (see_face<quadrature, fourth_order>(c, face, j + k, first_lanes(count - k), kept + chunk * size))
      used = chunk + 1;
    else
      for (int l = 0; l < size; ++l) kept[chunk * size + l] = 0.;
  active = std::uint16_t(used);
  kept += used * size;
  j += (count + list_padding - 1) / list_padding * list_padding;
}

/// gamma of all particles and its gradients; density before scaling.
template <bool fourth_order>
void wall_shares(CellView<3> &c) {
  const double iR = 1. / c.support;
  for (std::uint32_t i = 0; i <= c.n; ++i) {
    double *own = c.own + 4 * std::size_t(i);
    for (int d = 0; d < 3; ++d) own[d] = i < c.n ? (c.x[d][i] - c.wall_x[d]) * iR : 0.;
    own[3] = 0.;
    store_row(c.pull + 4 * std::size_t(i), splat_row(0.));
  }
  add_rims(c);
  double *kept = c.kept;
  Face face;
  for (std::uint32_t f = 0; f < c.n_faces; ++f) {
    const FaceList &list = c.face_lists[f];
    const std::uint16_t *j = c.face_particles + list.first;
    std::uint16_t *active = c.active + quadratures * std::size_t(f);
    prepare(c, list.face, face);
    see_face_all<0, fourth_order>(c, face, list.count[0], j, kept, active[0]);
    see_face_all<1, fourth_order>(c, face, list.count[1], j, kept, active[1]);
    see_face_all<2, fourth_order>(c, face, list.count[2], j, kept, active[2]);
  }
  for (std::uint32_t i = 0; i < c.n; ++i)
    correct<3, fourth_order>(c, i, 1. + c.pull[4 * std::size_t(i)] * (1. / (8. * pi)));
}

/// Sums of push S (x, 1) into `whole` and of push K_g (x, 1) into `point`.
template <int quadrature>
inline void sum_pushes(const CellView<3> &c, const std::uint32_t count, const std::uint32_t active,
                       const std::uint16_t *&j, const double *&kept, Row &whole, Row *point) {
  constexpr int points = quadrature_points[quadrature];
  Row sums[points + 1];
  sums[0] = whole;
  for (int g = 0; g < points; ++g) sums[g + 1] = splat_row(0.);
  const std::uint32_t last = active * W < count ? active * W : count;
  for (std::uint32_t k = 0; k < last; k += W, kept += (points + 1) * W)
    for (std::uint32_t l = 0; l < W && k + l < last; ++l) {
      const Row x = load_row(c.own + 4 * std::uint32_t(j[k + l]));
      for (int g = 0; g <= points; ++g) sums[g] += x * splat_row(kept[g * W + l]);
    }
  whole = sums[0];
  for (int g = 0; g < points; ++g) point[g] = sums[g + 1];
  j += (count + list_padding - 1) / list_padding * list_padding;
}

/// Forces between fluid and wall.
void push_wall(CellView<3> &c) {
  const double factor = 1. / (8. * pi * c.support), iR = 1. / c.support;
  for (std::uint32_t i = 0; i < c.n; ++i) {
    double *own = c.own + 4 * std::size_t(i);
    const double push = factor * c.push[i];
    for (int d = 0; d < 3; ++d) own[d] = push * (c.x[d][i] - c.wall_x[d]) * iR;
    own[3] = push;
  }
  const double *kept = c.kept;
  Face face;
  for (std::uint32_t f = 0; f < c.n_faces; ++f) {
    const FaceList &list = c.face_lists[f];
    const std::uint16_t *j = c.face_particles + list.first, *active = c.active + quadratures * std::size_t(f),
                        *node = c.corners + 3 * std::size_t(list.face);
    look_at(c, list.face, face);
    Row whole = splat_row(0.), six[6], three[3], one[1];
    sum_pushes<0>(c, list.count[0], active[0], j, kept, whole, six);
    sum_pushes<1>(c, list.count[1], active[1], j, kept, whole, three);
    sum_pushes<2>(c, list.count[2], active[2], j, kept, whole, one);
    // sum over points and particles of P l_gk K_g (y_g - x), the particles' x from the face's middle now
    double total[3][3] = {};  // corners
    const auto add_points = [&](const int quadrature, const Row *point) {
      for (int g = 0; g < quadrature_points[quadrature]; ++g)
        for (int d = 0; d < 3; ++d) {
          double y = face.middle[d];
          if (quadrature_points[quadrature] > 1)
            y += orbits[quadrature][g / 3].delta() * face.corner[g % 3][d];
          const double pull = y * point[g][3] - point[g][d];
          for (int k = 0; k < 3; ++k) total[k][d] += share_of(quadrature, g, k) * pull;
        }
    };
    if (active[0] > 0) add_points(0, six);
    if (active[1] > 0) add_points(1, three);
    if (active[2] > 0) add_points(2, one);
    double x[3];
    for (int d = 0; d < 3; ++d) x[d] = whole[d] - face.middle[d] * whole[3];
    for (int k = 0; k < 3; ++k) {
      const double *b = face.corner[(k + 1) % 3], *e = face.corner[(k + 2) % 3];
      double *force = c.wall_f + 4 * std::uint32_t(node[k]);
      for (int d = 0; d < 3; ++d) {  // (b - x) x (e - x) = b x e - x x (e - b)
        const int d1 = (d + 1) % 3, d2 = (d + 2) % 3;
        force[d] += total[k][d] + whole[3] * (b[d1] * e[d2] - b[d2] * e[d1]) -
                    (x[d1] * (e[d2] - b[d2]) - x[d2] * (e[d1] - b[d1]));
      }
    }
  }
  push_rims(c, factor);
  for (std::uint32_t i = 0; i < c.n; ++i) {
    const double *pull = c.pull + 4 * std::size_t(i), push = factor * c.push[i];
    for (int d = 0; d < 3; ++d) c.f[d][i] -= push * pull[1 + d];
  }
}
}  // namespace
}  // namespace turgor::sph
