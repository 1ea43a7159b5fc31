// The wall's part of the sweeps of sph_sweeps.h in 3D: triangles, lane = triangle, all lengths over the support R.
// Included by sph_sweeps.inc.h alone and under its rule: anonymous namespace, no inline function of a shared header.
//
// With a, b, c the corners from the particle, N = a . (b x c) (twice the area times the distance of the plane), Gauss points
// r_g = sum_k l_k (corner k) and weights w_g, in units of 1/(8 pi):
//   integral G r.n dS        = N S,   S = sum_g w_g g(|r_g|),  g = 4 pi R^3 G = 14 - 84 u^2 + 140 u^3 - 90 u^4 + 21 u^5 (u < 1)
//   solid angle (Van Oosterom and Strackee 1983)  = 2 atan2(N, D),  D = |a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|
//   integral D r.n dS        = N S with  g = -(1 - u)^5 (1 + 5 u + 15 u^2 + 21 u^3) / u^3
// |r_g|^2 comes from the six products a.a ... c.a, its derivatives from sums over g: no Gauss point has coordinates. Quadratures
// of 6 (degree 4), 3 (degree 2) and 1 points: Dunavant 1985, 10.1002/nme.1620210612.
#pragma once

#include "micro/terms/sph_pairs.inc.h"

namespace turgor::sph
{
namespace
{
/// Three Gauss points that are alike: (alpha, beta, beta) and its turns, beta = (1 - alpha)/2, each of weight w.
struct Orbit
{
  double w, alpha;
};
constexpr Orbit six_points[2] = {{0.22338158967801147, 0.10810301816807023}, {0.10995174365532187, 0.81684757298045851}};
constexpr Orbit three_points[1] = {{1. / 3., 2. / 3.}};

struct Vec
{
  V x, y, z;
};
inline V dot(const Vec &a, const Vec &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(const Vec &a, const Vec &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// s p + t (i a + j b + k c)
inline Vec combine(const V s, const Vec &p, const V t, const V i, const Vec &a, const V j, const Vec &b, const V k, const Vec &c)
{
  const V ti = t * i, tj = t * j, tk = t * k;
  return {s * p.x + ti * a.x + tj * b.x + tk * c.x, s * p.y + ti * a.y + tj * b.y + tk * c.y,
          s * p.z + ti * a.z + tj * b.z + tk * c.z};
}

/// At a Gauss point: g, (1/u) dg/du and the kernel over its peak.
template <int quadrature>
inline void profile(const V r2, V &value, V &slope, V &kernel)
{
  const V one = splat(1.), ir = rsqrt(r2), u = r2 * ir, w = positive(one - u), w2 = w * w;
  kernel = w2 * w2 * (splat(4.) * u + one);
  if constexpr (quadrature == 0)
    {
      const V outside = ir * ir * ir;
      value = select_less(u, one, splat(14.) + r2 * (splat(-84.) + u * (splat(140.) + u * (splat(-90.) + u * splat(21.)))),
                          outside);
      slope = select_less(u, one, splat(-168.) + u * (splat(420.) + u * (splat(-360.) + u * splat(105.))),
                          splat(-3.) * outside * (ir * ir));
    }
  else
    {
      const V ir2 = ir * ir;
      value = -(w2 * w2 * w) * (one + u * (splat(5.) + u * (splat(15.) + u * splat(21.)))) * (ir2 * ir);
      slope = ir2 * (splat(42.) * kernel - splat(3.) * value);
    }
}

/// What the fan of one particle is worked out in: rows of 4 doubles, a row a node.
struct FanRows
{
  double *from = nullptr;     ///< node minus particle, over R; length of this in column 3, where it is needed
  double *velocity = nullptr; ///< particle minus node, m/s
  double *drag = nullptr;     ///< out: sums of weight times tangential velocity
  double *gradient = nullptr; ///< out: 8 pi R d gamma / d node
};

/// W faces; returns 8 pi times what they give to gamma.
template <int quadrature, bool viscous>
inline V sum_triangles(const FanRows &fan, const std::uint16_t *corner)
{
  const V tiny = splat(1e-24);
  V column[4];
  load_half_rows<4>(fan.from, corner, column);
  const Vec a{column[0], column[1], column[2]};
  const V la = column[3];
  load_half_rows<4>(fan.from, corner + list_padding, column);
  const Vec b{column[0], column[1], column[2]};
  const V lb = column[3];
  load_half_rows<4>(fan.from, corner + 2 * list_padding, column);
  const Vec c{column[0], column[1], column[2]};
  const V lc = column[3];
  const Vec bxc = cross(b, c), cxa = cross(c, a), axb = cross(a, b);
  const V N = dot(a, bxc), aa = dot(a, a), bb = dot(b, b), cc = dot(c, c), ab = dot(a, b), bc = dot(b, c), ca = dot(c, a);

  // With s = a + b + c a point is beta s + (alpha - beta) a, so that |r|^2 takes three products, and of sum_g w slope l_j l_k
  // everything but one term is common to the three points of an orbit.
  const V sa = aa + ab + ca, sb = ab + bb + bc, sc = ca + bc + cc, ss = sa + sb + sc;
  V S = splat(0.), Maa, Mbb, Mcc, Mab, Mbc, Mca, Ka, Kb, Kc;
  if constexpr (quadrature == 3)
    {
      V slope, kernel;
      profile<quadrature>(splat(1. / 9.) * ss + tiny, S, slope, kernel);
      Maa = Mbb = Mcc = Mab = Mbc = Mca = splat(1. / 9.) * slope;
      Ka = Kb = Kc = splat(1. / 3.) * kernel;
    }
  else
    {
      constexpr bool three = quadrature == 2;
      Maa = Mbb = Mcc = Mab = Mbc = Mca = Ka = Kb = Kc = splat(0.);
      for (int o = 0; o < (three ? 1 : 2); ++o)
        {
          const Orbit orbit = three ? three_points[0] : six_points[o];
          const double w = orbit.w, alpha = orbit.alpha, beta = 0.5 * (1. - alpha), delta = alpha - beta;
          const V base = splat(beta * beta) * ss + tiny, first = splat(2. * beta * delta), second = splat(delta * delta);
          V value[3], slope[3], kernel[3];
          profile<quadrature>(base + first * sa + second * aa, value[0], slope[0], kernel[0]);
          profile<quadrature>(base + first * sb + second * bb, value[1], slope[1], kernel[1]);
          profile<quadrature>(base + first * sc + second * cc, value[2], slope[2], kernel[2]);
          S += splat(w) * (value[0] + value[1] + value[2]);
          const V all = slope[0] + slope[1] + slope[2], own = splat(w * beta * beta) * all, mixed = splat(w * alpha * beta) * all,
                  x = splat(w * (alpha * alpha - beta * beta)), y = splat(w * (beta * beta - alpha * beta));
          Maa += own + x * slope[0];
          Mbb += own + x * slope[1];
          Mcc += own + x * slope[2];
          Mbc += mixed + y * slope[0];
          Mca += mixed + y * slope[1];
          Mab += mixed + y * slope[2];
          if constexpr (viscous)
            {
              const V common = splat(w * beta) * (kernel[0] + kernel[1] + kernel[2]), more = splat(w * delta);
              Ka += common + more * kernel[0];
              Kb += common + more * kernel[1];
              Kc += common + more * kernel[2];
            }
        }
    }
  if constexpr (quadrature > 0)
    if (all_zero(S))
      return splat(0.); // the skin's faces: out of the support
  V share = N * S;
  if constexpr (quadrature == 0)
    {
      const V D = la * lb * lc + ab * lc + bc * la + ca * lb;
      const V q = splat(4.) * reciprocal(N * N + D * D + splat(1e-30));
      share -= splat(4.) * angle(N, D);
      S -= q * D;
      Maa += q * (lb * lc + bc) * reciprocal(la);
      Mbb += q * (lc * la + ca) * reciprocal(lb);
      Mcc += q * (la * lb + ab) * reciprocal(lc);
      Mab += q * lc;
      Mbc += q * la;
      Mca += q * lb;
    }
  const Vec da = combine(S, bxc, N, Maa, a, Mab, b, Mca, c), db = combine(S, cxa, N, Mab, a, Mbb, b, Mbc, c),
            dc = combine(S, axb, N, Mca, a, Mbc, b, Mcc, c);
  add_to_rows(fan.gradient, corner, da.x, da.y, da.z);
  add_to_rows(fan.gradient, corner + list_padding, db.x, db.y, db.z);
  add_to_rows(fan.gradient, corner + 2 * list_padding, dc.x, dc.y, dc.z);

  if constexpr (viscous)
    {
      // integral of W over the face / distance to its plane, split between its nodes
      const Vec n{bxc.x + cxa.x + axb.x, bxc.y + cxa.y + axb.y, bxc.z + cxa.z + axb.z};
      const V in = rsqrt(dot(n, n) + tiny), distance = N * in, least = splat(0.2); // half a particle spacing
      const V weight = reciprocal(in * select_less(distance, least, least, distance)), in2 = in * in;
      const V parts[3] = {Ka * weight, Kb * weight, Kc * weight};
      for (int k = 0; k < 3; ++k)
        {
          load_half_rows<4>(fan.velocity, corner + k * list_padding, column);
          const V normal = (column[0] * n.x + column[1] * n.y + column[2] * n.z) * in2;
          add_to_rows(fan.drag, corner + k * list_padding, parts[k] * (column[0] - normal * n.x),
                      parts[k] * (column[1] - normal * n.y), parts[k] * (column[2] - normal * n.z));
        }
    }
  return share;
}

template <int quadrature, bool viscous>
inline V sum_fan(const FanRows &rows, const Fan &fan, const std::uint16_t *&corner)
{
  V share = splat(0.);
  const std::uint32_t faces = fan.faces[quadrature];
  for (std::uint32_t k = 0; k < faces; k += W)
    share += sum_triangles<quadrature, viscous>(rows, corner + (k / list_padding) * 3 * list_padding + k % list_padding);
  corner += (faces + list_padding - 1) / list_padding * 3 * list_padding;
  return share;
}

/// gamma of all particles and its gradients; density before scaling; the drag on the wall but for the factor 1/s.
template <bool viscous>
void wall_shares(CellView<3> &c)
{
  const double iR = 1. / c.support;
  std::uint32_t largest = 0;
  for (std::uint32_t i = 0; i < c.n; ++i)
    largest = largest < c.fans[i].nodes ? c.fans[i].nodes : largest;
  FanRows rows;
  rows.from = c.fan_scratch;
  rows.velocity = rows.from + 4 * largest;
  rows.drag = rows.velocity + 4 * largest;
  if (viscous)
    for (std::uint32_t k = 0; k < 4 * c.n_wall; ++k)
      c.wall_drag[k] = 0.;
  for (std::uint32_t i = 0; i < c.n; ++i)
    {
      const Fan &fan = c.fans[i];
      const std::uint16_t *node = c.fan_nodes + fan.first_node, *corner = c.fan_corners + fan.first_corner;
      rows.gradient = c.scratch + 4 * std::size_t(fan.first_node);
      const double xi[3] = {c.x[0][i], c.x[1][i], c.x[2][i]};
      for (std::uint32_t k = 0; k < fan.nodes; ++k)
        {
          const double *x = c.wall_x + 4 * std::uint32_t(node[k]);
          double *from = rows.from + 4 * k, *gradient = rows.gradient + 4 * k;
          for (int d = 0; d < 3; ++d)
            {
              from[d] = (x[d] - xi[d]) * iR;
              gradient[d] = 0.;
            }
          gradient[3] = 0.;
          if (k < fan.near_nodes)
            from[3] = __builtin_sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2] + 1e-24);
          else
            from[3] = 0.;
          if (viscous)
            {
              const double *v = c.wall_v + 4 * std::uint32_t(node[k]);
              for (int d = 0; d < 3; ++d)
                {
                  rows.velocity[4 * k + d] = c.v[d][i] - v[d];
                  rows.drag[4 * k + d] = 0.;
                }
              rows.velocity[4 * k + 3] = rows.drag[4 * k + 3] = 0.;
            }
        }
      V share = sum_fan<0, viscous>(rows, fan, corner);
      share += sum_fan<1, viscous>(rows, fan, corner);
      share += sum_fan<2, viscous>(rows, fan, corner);
      share += sum_fan<3, viscous>(rows, fan, corner);
      if (viscous)
        {
          // W = 21/(2 pi R^3), area R^2/2, distance R; rho is still the plain sum: V/gamma = m/(s rho)
          const double factor = 2. * c.viscosity * c.mass / c.rho[i] * (21. / (4. * pi)) * iR * iR;
          double total[3] = {0., 0., 0.};
          for (std::uint32_t k = 0; k < fan.nodes; ++k)
            for (int d = 0; d < 3; ++d)
              {
                const double f = factor * rows.drag[4 * k + d];
                c.wall_drag[4 * std::uint32_t(node[k]) + d] += f;
                total[d] -= f;
              }
          for (int d = 0; d < 3; ++d)
            c.own_drag[4 * i + d] = total[d];
        }
      correct(c, i, 1. + sum(share) * (1. / (8. * pi)));
    }
}

/// Forces between fluid and wall.
template <bool viscous>
void push_wall(CellView<3> &c)
{
  for (std::uint32_t i = 0; i < c.n; ++i)
    {
      const Fan &fan = c.fans[i];
      if (fan.nodes == 0)
        continue;
      const std::uint16_t *node = c.fan_nodes + fan.first_node;
      const double *gradient = c.scratch + 4 * std::size_t(fan.first_node);
      const double push = c.push[i] / (8. * pi * c.support);
      double total[4] = {0., 0., 0., 0.};
      for (std::uint32_t k = 0; k < fan.nodes; ++k)
        {
          double *f = c.wall_f + 4 * std::uint32_t(node[k]);
          for (int d = 0; d < 4; ++d)
            {
              const double part = push * gradient[4 * k + d];
              f[d] += part;
              total[d] += part;
            }
        }
      for (int d = 0; d < 3; ++d)
        c.f[d][i] -= total[d];
      if (viscous)
        for (int d = 0; d < 3; ++d)
          c.f[d][i] += c.own_drag[4 * i + d] / c.scale;
    }
  if (viscous)
    for (std::uint32_t k = 0; k < 4 * c.n_wall; ++k)
      c.wall_f[k] += c.wall_drag[k] / c.scale;
}
} // namespace
} // namespace turgor::sph
