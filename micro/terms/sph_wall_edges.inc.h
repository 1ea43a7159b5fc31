// The wall's part of the sweeps of sph_sweeps.h in 2D: a ring of edges, read by stretches (arcs), lane =
// edge. Included by sph_sweeps.inc.h alone and under its rule: anonymous namespace, no inline function of a
// shared header.
#pragma once

#include "micro/terms/sph_pairs.inc.h"

namespace turgor::sph {
namespace {
alignas(64) const double lane_number[8] = {0, 1, 2, 3, 4, 5, 6, 7};

/// What one particle feels of one stretch of wall: gamma and its derivatives with respect to
/// the face's two nodes, lane = face, kept until p_i is known.
struct Gradient {
  V ax, ay, bx, by;
};

/// What the faces within reach give to gamma and its gradient, angles left out.
template <bool fourth_order>
void sum_faces(CellView<2> &c) {
  using K = Kernel<2, fourth_order>;
  const double R = c.support, iR = 1. / R;
  const V iR2 = splat(iR * iR), one = splat(1.), tiny = splat(1e-24);
  // Gauss points and weights on [0, 1].
  constexpr int gauss_points = 3;
  const double gauss_x[gauss_points] = {0.11270166537925831, 0.5, 0.88729833462074169};
  const double gauss_w[gauss_points] = {5. / 18., 8. / 18., 5. / 18.};

  Gradient *gradients = reinterpret_cast<Gradient *>(c.scratch);

  std::uint32_t chunks = 0;
  for (std::uint32_t i = 0; i < c.n; ++i) {
    const double *row = c.rows + std::size_t(i) * row_doubles;
    const V xi = splat(row[0]), yi = splat(row[1]);
    V share = splat(0.);
    for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc) {
      const std::uint32_t first = c.arcs[arc].first, count = c.arcs[arc].count;
      for (std::uint32_t k = 0; k < count; k += W, ++chunks) {
        const std::uint32_t at = first + k;
        const V live = splat(double(count - k)), lane = load(lane_number);
        const V ax = load(c.wall_x[0] + at) - xi, ay = load(c.wall_x[1] + at) - yi;
        const V bx = load(c.wall_x[0] + at + 1) - xi, by = load(c.wall_x[1] + at + 1) - yi;
        const V cross = ax * by - ay * bx;
        const V ex = bx - ax, ey = by - ay;
        // |r|^2 = aa + 2 x ae + x^2 ee at x in [0, 1], over the support squared
        const V aa = (ax * ax + ay * ay) * iR2, ae = (ax * ex + ay * ey) * iR2,
                ee = (ex * ex + ey * ey) * iR2, ae2 = ae + ae;
        // sums of w G, of w x^k (1/u) dG/du
        V s = splat(0.), slope0 = s, slope1 = s, slope2 = s;
        for (int g = 0; g < gauss_points; ++g) {
          const double x = gauss_x[g], weight = gauss_w[g];
          const V u2 = greater(aa + splat(x) * (ae2 + splat(x) * ee), tiny), u = root(u2),
                  iu2 = reciprocal(u2);
          const V inside = K::share(u, u2, K::alpha);
          // (1/u) d(inside)/du
          const V slope = K::share_slope(u, K::alpha);
          // in units of 7/(pi R^2): beyond the support G = 1/(2 pi r^2)
          const V outside = splat(1. / 14.) * iu2;
          const V G = select_less(u2, one, inside, outside),
                  dG = select_less(u2, one, slope, splat(-2.) * outside * iu2);
          s += splat(weight) * G;
          slope0 += splat(weight) * dG;
          slope1 += splat(weight * x) * dG;
          slope2 += splat(weight * x * x) * dG;
        }
        const V sbx = slope1 * ax + slope2 * ex, sby = slope1 * ay + slope2 * ey,
                sax = slope0 * ax + slope1 * ex - sbx, say = slope0 * ay + slope1 * ey - sby;
        const double scale = 7. / (pi * R * R), scale_grad = scale * iR * iR;
        const V S = s * splat(scale);
        const V cg = cross * splat(scale_grad);
        const V zero = splat(0.);
        // Whole turns: counted where a face passes the direction in which angle() jumps.
        const V down = select_less(by, zero, select_less(zero, cross, one, zero), zero);
        const V up = select_less(by, zero, zero, select_less(cross, zero, one, zero));
        const V turns = select_less(ay, zero, -up, down);
        share += select_less(lane, live, cross * S - turns, zero);
        Gradient &out = gradients[chunks];
        out.ax = select_less(lane, live, by * S + cg * sax, zero);
        out.ay = select_less(lane, live, cg * say - bx * S, zero);
        out.bx = select_less(lane, live, cg * sbx - ay * S, zero);
        out.by = select_less(lane, live, ax * S + cg * sby, zero);
      }
    }
    c.gamma[i] = 1. + sum(share);
  }
}

/// The angle under which a stretch of wall is seen, from its two ends alone, and its gradient: gamma
/// is complete, and rho as the sums give it.
template <bool fourth_order>
void add_angles(CellView<2> &c) {
  const double R = c.support;
  const V tiny = splat(1e-24 * R * R);
  const std::uint32_t arcs = c.first_arc[c.n], stride = c.arc_stride;
  double *ends = c.arc_ends;
  for (std::uint32_t i = 0; i < c.n; ++i)
    for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc) {
      const std::uint32_t a = c.arcs[arc].first, b = a + c.arcs[arc].count;
      ends[arc] = c.wall_x[0][a] - c.x[0][i];
      ends[arc + stride] = c.wall_x[1][a] - c.x[1][i];
      ends[arc + 2 * stride] = c.wall_x[0][b] - c.x[0][i];
      ends[arc + 3 * stride] = c.wall_x[1][b] - c.x[1][i];
    }
  for (std::uint32_t arc = arcs; arc < stride; ++arc)
    for (std::uint32_t k = 0; k < 4; ++k) ends[arc + k * stride] = R;
  for (std::uint32_t arc = 0; arc < arcs; arc += W) {
    double *x0 = ends + arc, *y0 = x0 + stride, *x1 = y0 + stride, *y1 = x1 + stride;
    const V ax = load(x0), ay = load(y0), bx = load(x1), by = load(y1), turn = splat(1. / (2. * pi));
    store(y1 + stride, turn * (angle(by, bx) - angle(ay, ax)));
    const V a2 = turn * reciprocal(ax * ax + ay * ay + tiny),
            b2 = turn * reciprocal(bx * bx + by * by + tiny);
    store(x0, -ay * a2);
    store(y0, ax * a2);
    store(x1, by * b2);
    store(y1, -bx * b2);
  }
  for (std::uint32_t i = 0; i < c.n; ++i) {
    double gamma = c.gamma[i];
    for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc) gamma -= ends[arc + 4 * stride];
    correct<2, fourth_order>(c, i, gamma);
  }
}

/// Forces between fluid and wall.
void push_wall(CellView<2> &c) {
  const Gradient *gradients = reinterpret_cast<const Gradient *>(c.scratch);
  const double *ends = c.arc_ends;
  const std::uint32_t stride = c.arc_stride;
  std::uint32_t chunk = 0;
  for (std::uint32_t i = 0; i < c.n; ++i) {
    if (c.first_arc[i] < c.first_arc[i + 1]) {
      const double push = c.push[i];
      const V b = splat(push);
      V fx = splat(0.), fy = splat(0.);
      double end_x = 0., end_y = 0.;
      for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc) {
        const std::uint32_t first = c.arcs[arc].first, last = first + c.arcs[arc].count - 1;
        const double *end = ends + arc;
        const double ax = push * end[0], ay = push * end[stride], bx = push * end[2 * stride],
                     by = push * end[3 * stride];
        c.wall_f[0][first] += ax;
        c.wall_f[1][first] += ay;
        c.wall_f_next[0][last] += bx;
        c.wall_f_next[1][last] += by;
        end_x += ax + bx;
        end_y += ay + by;
        for (std::uint32_t k = 0; k < c.arcs[arc].count; k += W, ++chunk) {
          const std::uint32_t at = c.arcs[arc].first + k;
          const Gradient &g = gradients[chunk];
          const V fax = b * g.ax, fay = b * g.ay, fbx = b * g.bx, fby = b * g.by;
          store(c.wall_f[0] + at, load(c.wall_f[0] + at) + fax);
          store(c.wall_f[1] + at, load(c.wall_f[1] + at) + fay);
          store(c.wall_f_next[0] + at, load(c.wall_f_next[0] + at) + fbx);
          store(c.wall_f_next[1] + at, load(c.wall_f_next[1] + at) + fby);
          fx += fax + fbx;
          fy += fay + fby;
        }
      }
      c.f[0][i] -= sum(fx) + end_x;
      c.f[1][i] -= sum(fy) + end_y;
    }
  }
}

/// gamma of all particles; density before scaling.
template <bool fourth_order>
void wall_shares(CellView<2> &c) {
  sum_faces<fourth_order>(c);
  add_angles<fourth_order>(c);
}
}  // namespace
}  // namespace turgor::sph
