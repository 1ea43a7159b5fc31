// The angle under which a particle sees its near faces, from their rims alone (what the faces have in common
// cancels); lane = side of a rim, all lengths over the support R. Included by sph_wall_triangles.inc.h alone.
//
// With d a unit vector, b and c the ends of a side from the particle:
//   angle of the patch = sum over sides of 2 atan2(N, D) + 4 pi (times the sign with which the ray along -d
//     meets the patch)
//     N = d . (b x c),  D = |b||c| + b.c + (d.b)|c| + (d.c)|b|      (triangle of b, c and a corner far away
//                       along d)
//   d angle / db = - integral (1 - t) (b x c) / |r|^3 dt over the side = - (b x c) / (|b| (|b||c| + b.c)), dc
//     alike.
// d looks at a near face when the lists are built, so that few faces can be behind (Doubt).
#pragma once

#include "micro/terms/sph_pairs.inc.h"

namespace turgor::sph {
namespace {
struct Vec {
  V x, y, z;
};
inline V dot(const Vec &a, const Vec &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(const Vec &a, const Vec &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec splat(const double *a) { return {splat(a[0]), splat(a[1]), splat(a[2])}; }

/// Where the ray from a particle away from `toward` meets a face in doubt, the angle is off by a full turn.
inline void settle_doubts(CellView<3> &c) {
  for (std::uint32_t k = 0; k < c.n_doubts; ++k) {
    const std::uint32_t i = c.doubts[k].particle;
    const std::uint16_t *corner = c.corners + 3 * std::size_t(c.doubts[k].face);
    const double *d = c.toward + 3 * std::size_t(i);
    double r[3][3], across[3], volume = 0.;
    for (int a = 0; a < 3; ++a)
      for (int e = 0; e < 3; ++e) r[a][e] = c.wall_x[4 * corner[a] + e] - c.x[e][i];
    for (int a = 0; a < 3; ++a) {
      const double *p = r[a], *q = r[(a + 1) % 3], *opposite = r[(a + 2) % 3];
      const double e[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
      across[a] = d[0] * e[0] + d[1] * e[1] + d[2] * e[2];
      volume = opposite[0] * e[0] + opposite[1] * e[1] + opposite[2] * e[2];
    }
    if (volume > 0. && across[0] < 0. && across[1] < 0. && across[2] < 0.)
      c.pull[4 * std::size_t(i)] -= 8. * pi;
    else if (volume < 0. && across[0] > 0. && across[1] > 0. && across[2] > 0.)
      c.pull[4 * std::size_t(i)] += 8. * pi;
  }
}

/// Adds -2 times the angle to column 0 of `pull` and its gradient to the others; the nodes' gradients to
/// rim_pull.
inline void add_rims(CellView<3> &c) {
  std::uint32_t longest = 0;
  for (std::uint32_t k = 0; k < c.n_rims; ++k)
    longest = longest < c.rims[k].count ? c.rims[k].count : longest;
  const std::uint32_t stride = (longest + 2 * list_padding - 1) / list_padding * list_padding;
  double *rx = c.rim_scratch, *ry = rx + stride, *rz = ry + stride, *length = rz + stride,
         *ex = length + stride + 8, *ey = ex + stride,
         *ez = ey + stride;  // e: of the side that begins here; [-1]: of the last one
  const V iR = splat(1. / c.support), tiny = splat(1e-24), two = splat(2.);
  for (std::uint32_t rim = 0; rim < c.n_rims; ++rim) {
    const std::uint32_t i = c.rims[rim].particle, count = c.rims[rim].count, padded = (count + W - 1) / W * W;
    const std::uint16_t *node = c.rim_nodes + c.rims[rim].first;
    const double at[3] = {c.x[0][i], c.x[1][i], c.x[2][i]};
    const Vec x = splat(at), d = splat(c.toward + 3 * std::size_t(i));
    for (std::uint32_t k = 0; k < padded; k += W) {
      V column[4];
      load_half_rows<4>(c.wall_x, node + k, column);
      const Vec r{(column[0] - x.x) * iR, (column[1] - x.y) * iR, (column[2] - x.z) * iR};
      store(rx + k, r.x);
      store(ry + k, r.y);
      store(rz + k, r.z);
      store(length + k, root(dot(r, r) + tiny));
    }
    rx[padded] = rx[0];
    ry[padded] = ry[0];
    rz[padded] = rz[0];
    length[padded] = length[0];
    V half = splat(0.);
    for (std::uint32_t k = 0; k < padded; k += W) {
      const V live = first_lanes(count - k);
      const Vec b{load(rx + k), load(ry + k), load(rz + k)},
          r{load(rx + k + 1), load(ry + k + 1), load(rz + k + 1)}, e = cross(b, r);
      const V lb = load(length + k), lr = load(length + k + 1), plain = lb * lr + dot(b, r);
      half += live * angle(dot(d, e), plain + dot(d, b) * lr + dot(d, r) * lb);
      const V scale = live * two * reciprocal(plain + tiny);
      store(ex + k, scale * e.x);
      store(ey + k, scale * e.y);
      store(ez + k, scale * e.z);
    }
    ex[-1] = ex[count - 1];
    ey[-1] = ey[count - 1];
    ez[-1] = ez[count - 1];
    Vec total{splat(0.), splat(0.), splat(0.)};
    double *pull = c.rim_pull + 4 * std::size_t(c.rims[rim].first);
    for (std::uint32_t k = 0; k < padded; k += W) {
      const V il = first_lanes(count - k) * reciprocal(load(length + k));
      const V g[4] = {il * (load(ex + k) + load(ex + k - 1)), il * (load(ey + k) + load(ey + k - 1)),
                      il * (load(ez + k) + load(ez + k - 1)), splat(0.)};
      total = {total.x + g[0], total.y + g[1], total.z + g[2]};
      to_rows(g, [&](const std::uint32_t l, const Row row) { store_row(pull + 4 * (k + l), row); });
    }
    double *sums = c.pull + 4 * std::size_t(i);
    sums[0] -= 4. * sum(half);
    sums[1] += sum(total.x);
    sums[2] += sum(total.y);
    sums[3] += sum(total.z);
  }
  settle_doubts(c);
}

/// Forces of the rims on their nodes; factor times push is the slope of the energy with 8 pi gamma, over R.
inline void push_rims(CellView<3> &c, const double factor) {
  for (std::uint32_t rim = 0; rim < c.n_rims; ++rim) {
    const Row push = splat_row(factor * c.push[c.rims[rim].particle]);
    const std::uint16_t *node = c.rim_nodes + c.rims[rim].first;
    const double *pull = c.rim_pull + 4 * std::size_t(c.rims[rim].first);
    for (std::uint32_t k = 0; k < c.rims[rim].count; ++k) {
      double *f = c.wall_f + 4 * std::uint32_t(node[k]);
      store_row(f, load_row(f) + push * load_row(pull + 4 * k));
    }
  }
}
}  // namespace
}  // namespace turgor::sph
