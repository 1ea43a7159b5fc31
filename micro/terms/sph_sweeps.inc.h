// Body of the sweeps of sph_sweeps.h; included by one file per instruction set, which
// defines TURGOR_SWEEPS (the function that returns them). Everything here is in an
// anonymous namespace and calls no inline function of a shared header: a copy compiled
// for a wide machine must never be the one the linker keeps for all.
#include "micro/terms/sph_sweeps.h"

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <immintrin.h>
#endif

namespace turgor::sph
{
namespace
{
#if defined(__AVX512F__) && defined(__AVX512DQ__)
constexpr int W = 8;
using V = __m512d;
inline V splat(double a) { return _mm512_set1_pd(a); }
inline V load(const double *p) { return _mm512_loadu_pd(p); }
inline void store(double *p, V a) { _mm512_storeu_pd(p, a); }
inline V positive(V a) { return _mm512_max_pd(a, _mm512_setzero_pd()); }
inline V select_less(V a, V b, V yes, V no) { return _mm512_mask_blend_pd(_mm512_cmp_pd_mask(a, b, _CMP_LT_OQ), no, yes); }
inline double sum(V a) { return _mm512_reduce_add_pd(a); }
/// 1/sqrt(a), a > 0: hardware estimate (14 bit) and two Newton steps (full precision).
inline V rsqrt(V a)
{
  V y = _mm512_rsqrt14_pd(a);
  const V h = _mm512_mul_pd(a, splat(0.5));
  y = _mm512_mul_pd(y, _mm512_fnmadd_pd(_mm512_mul_pd(h, y), y, splat(1.5)));
  y = _mm512_mul_pd(y, _mm512_fnmadd_pd(_mm512_mul_pd(h, y), y, splat(1.5)));
  return y;
}
/// 1/a: hardware estimate and two Newton steps.
inline V reciprocal(V a)
{
  V y = _mm512_rcp14_pd(a);
  y = _mm512_mul_pd(y, _mm512_fnmadd_pd(a, y, splat(2.)));
  return _mm512_mul_pd(y, _mm512_fnmadd_pd(a, y, splat(2.)));
}
inline void load_xy(const double *rows, const std::uint16_t *j, V &x, V &y)
{
  const auto at = [&](int k) { return _mm_load_pd(rows + std::uint32_t(j[k]) * row_doubles); };
  const __m256d p0 = _mm256_insertf128_pd(_mm256_castpd128_pd256(at(0)), at(1), 1);
  const __m256d p1 = _mm256_insertf128_pd(_mm256_castpd128_pd256(at(2)), at(3), 1);
  const __m256d p2 = _mm256_insertf128_pd(_mm256_castpd128_pd256(at(4)), at(5), 1);
  const __m256d p3 = _mm256_insertf128_pd(_mm256_castpd128_pd256(at(6)), at(7), 1);
  const V a = _mm512_insertf64x4(_mm512_castpd256_pd512(p0), p1, 1);
  const V b = _mm512_insertf64x4(_mm512_castpd256_pd512(p2), p3, 1);
  x = _mm512_permutex2var_pd(a, _mm512_setr_epi64(0, 2, 4, 6, 8, 10, 12, 14), b);
  y = _mm512_permutex2var_pd(a, _mm512_setr_epi64(1, 3, 5, 7, 9, 11, 13, 15), b);
}
/// The rows j[0..7], transposed: c[k] holds column k of the eight rows.
inline void load_rows(const double *rows, const std::uint16_t *j, V c[row_doubles])
{
  V r[8];
  for (int k = 0; k < 8; ++k)
    r[k] = _mm512_load_pd(rows + std::uint32_t(j[k]) * row_doubles);
  V t[8];
  for (int k = 0; k < 8; k += 2)
    {
      t[k] = _mm512_unpacklo_pd(r[k], r[k + 1]);
      t[k + 1] = _mm512_unpackhi_pd(r[k], r[k + 1]);
    }
  for (int k = 0; k < 2; ++k)
    {
      const V a = _mm512_shuffle_f64x2(t[k], t[k + 2], 0x88), b = _mm512_shuffle_f64x2(t[k], t[k + 2], 0xdd);
      const V e = _mm512_shuffle_f64x2(t[k + 4], t[k + 6], 0x88), g = _mm512_shuffle_f64x2(t[k + 4], t[k + 6], 0xdd);
      c[k] = _mm512_shuffle_f64x2(a, e, 0x88);
      c[k + 4] = _mm512_shuffle_f64x2(a, e, 0xdd);
      c[k + 2] = _mm512_shuffle_f64x2(b, g, 0x88);
      c[k + 6] = _mm512_shuffle_f64x2(b, g, 0xdd);
    }
}
#else
constexpr int W = 4;
typedef double V __attribute__((vector_size(32)));
inline V splat(double a) { return V{a, a, a, a}; }
inline V load(const double *p) { V a; __builtin_memcpy(&a, p, sizeof a); return a; }
inline void store(double *p, V a) { __builtin_memcpy(p, &a, sizeof a); }
inline V positive(V a) { return a > splat(0.) ? a : splat(0.); }
inline V select_less(V a, V b, V yes, V no) { return a < b ? yes : no; }
inline double sum(V a) { return (a[0] + a[1]) + (a[2] + a[3]); }
inline V rsqrt(V a)
{
  V y;
  for (int k = 0; k < W; ++k)
    y[k] = 1. / __builtin_sqrt(a[k]);
  return y;
}
inline V reciprocal(V a) { return splat(1.) / a; }
inline void load_xy(const double *rows, const std::uint16_t *j, V &x, V &y)
{
  for (int k = 0; k < W; ++k)
    {
      const double *row = rows + std::uint32_t(j[k]) * row_doubles;
      x[k] = row[0];
      y[k] = row[1];
    }
}
inline void load_rows(const double *rows, const std::uint16_t *j, V c[row_doubles])
{
  for (int half = 0; half < 2; ++half)
    {
      V r[4];
      for (int k = 0; k < 4; ++k)
        r[k] = load(rows + std::uint32_t(j[k]) * row_doubles + 4 * half);
      typedef long long M __attribute__((vector_size(32)));
      const V lo0 = __builtin_shuffle(r[0], r[1], M{0, 4, 2, 6}), hi0 = __builtin_shuffle(r[0], r[1], M{1, 5, 3, 7});
      const V lo1 = __builtin_shuffle(r[2], r[3], M{0, 4, 2, 6}), hi1 = __builtin_shuffle(r[2], r[3], M{1, 5, 3, 7});
      c[4 * half] = __builtin_shuffle(lo0, lo1, M{0, 1, 4, 5});
      c[4 * half + 1] = __builtin_shuffle(hi0, hi1, M{0, 1, 4, 5});
      c[4 * half + 2] = __builtin_shuffle(lo0, lo1, M{2, 3, 6, 7});
      c[4 * half + 3] = __builtin_shuffle(hi0, hi1, M{2, 3, 6, 7});
    }
}
#endif

constexpr double pi = 3.14159265358979323846;

/// atan2(s, c) lane by lane (Cephes rational approximation, 2e-16).
inline V angle(V s, V c)
{
  const V zero = splat(0.), as = select_less(s, zero, -s, s), ac = select_less(c, zero, -c, c);
  const V big = select_less(as, ac, ac, as), small = select_less(as, ac, as, ac);
  const V wide = big * splat(0.41421356237309503); // tan(pi/8) < small/big: reduce by pi/4
  const V t = select_less(wide, small, small - big, small)
              * reciprocal(select_less(wide, small, small + big, big) + splat(1e-290));
  const V z = t * t;
  const V p = ((((splat(-8.750608600031904122785E-1) * z + splat(-1.615753718733365076637E1)) * z
                 + splat(-7.500855792314704667340E1)) * z + splat(-1.228866684490136173410E2)) * z
               + splat(-6.485021904942025371773E1)) * z;
  const V d = ((((z + splat(2.485846490142306297962E1)) * z + splat(1.650270098316988542046E2)) * z
                + splat(4.328810604912902668951E2)) * z + splat(4.853903996359136964868E2)) * z
              + splat(1.945506571482613964425E2);
  V a = t + t * (p * reciprocal(d));
  a = select_less(wide, small, a + splat(pi / 4), a);
  a = select_less(as, ac, a, splat(pi / 2) - a);
  a = select_less(c, zero, splat(pi) - a, a);
  return select_less(s, zero, -a, a);
}

alignas(64) const double lane_number[8] = {0, 1, 2, 3, 4, 5, 6, 7};

/// What one particle feels of one stretch of wall: gamma and its derivatives with respect to
/// the face's two nodes, lane = face, kept until p_i is known.
struct Gradient
{
  V ax, ay, bx, by;
};

template <bool viscous>
void density(CellView &c)
{
  const double R = c.support, iR = 1. / R, C = 7. / (pi * R * R) / c.depth;
  const V viR = splat(iR), one = splat(1.), four = splat(4.), tiny = splat(1e-24 * R * R);

  for (std::uint32_t i = 0; i < c.n; ++i)
    {
      double *row = c.rows + std::size_t(i) * row_doubles;
      row[0] = c.x[0][i];
      row[1] = c.x[1][i];
      if (viscous)
        {
          row[2] = c.v[0][i];
          row[3] = c.v[1][i];
        }
    }
  double *dummy = c.rows + std::size_t(c.n) * row_doubles;
  dummy[0] = c.x[0][0] + 1e3 * R;
  dummy[1] = c.x[1][0] + 1e3 * R;
  for (unsigned int k = 2; k < row_doubles; ++k)
    dummy[k] = 0.;

  // Gauss points and weights on [0, 1].
  constexpr int gauss_points = 3;
  const double gauss_x[gauss_points] = {0.11270166537925831, 0.5, 0.88729833462074169};
  const double gauss_w[gauss_points] = {5. / 18., 8. / 18., 5. / 18.};

  Gradient *gradients = reinterpret_cast<Gradient *>(c.scratch);
  V *slip = reinterpret_cast<V *>(c.scratch + c.scratch_half);
  c.crossed = 0;

  // In blocks of particles: shares and sums first, then the law for the whole block, then the wall's forces.
  std::uint32_t first_chunk[block + 1];
  double rho[block], pressure[block];
  for (std::uint32_t begin = 0; begin < c.n; begin += block)
  {
  const std::uint32_t end = begin + block < c.n ? begin + block : c.n;
  std::uint32_t chunks = 0;
  for (std::uint32_t i = begin; i < end; ++i)
    {
      first_chunk[i - begin] = chunks;
      double *row = c.rows + std::size_t(i) * row_doubles;
      const V xi = splat(row[0]), yi = splat(row[1]);
      V acc = splat(0.);
      for (std::uint32_t k = c.first_neighbour[i]; k < c.first_neighbour[i + 1]; k += W)
        {
          V xj, yj;
          load_xy(c.rows, c.neighbours + k, xj, yj);
          const V dx = xj - xi, dy = yj - yi, r2 = dx * dx + dy * dy + tiny;
          const V u = r2 * rsqrt(r2) * viR;
          const V w = positive(one - u), w2 = w * w;
          acc += w2 * w2 * (four * u + one);
        }
      const double kernel_sum = C * (1. + sum(acc));

      double gamma = 1.;
      for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc)
        {
          const std::uint32_t first = c.arcs[arc].first, count = c.arcs[arc].count;
          for (std::uint32_t k = 0; k < count; k += W, ++chunks)
            {
              const std::uint32_t at = first + k;
              const V live = splat(double(count - k)), lane = load(lane_number);
              const V ax = load(c.wall_x[0] + at) - xi, ay = load(c.wall_x[1] + at) - yi;
              const V bx = load(c.wall_x[0] + at + 1) - xi, by = load(c.wall_x[1] + at + 1) - yi;
              const V cross = ax * by - ay * bx, dot = ax * bx + ay * by;
              const V ex = bx - ax, ey = by - ay;
              V s = splat(0.), sax = s, say = s, sbx = s, sby = s, wa = s, wb = s;
              for (int g = 0; g < gauss_points; ++g)
                {
                  const V rx = ax + splat(gauss_x[g]) * ex, ry = ay + splat(gauss_x[g]) * ey;
                  const V r2 = rx * rx + ry * ry + tiny, ir = rsqrt(r2), u = r2 * ir * viR, u2 = u * u;
                  const V inside = splat(0.5) + u2 * (splat(-2.5) + u * (four + u * (splat(-2.5) + u * splat(4. / 7.))));
                  // (1/u) d(inside)/du
                  const V slope = splat(-5.) + u * (splat(12.) + u * (splat(-10.) + u * splat(20. / 7.)));
                  // in units of 7/(pi R^2): beyond the support G = 1/(2 pi r^2)
                  const V outside = splat(1. / 14.) * (ir * ir) * splat(R * R);
                  const V G = select_less(u, one, inside, outside) * splat(gauss_w[g]);
                  const V dG = select_less(u, one, slope, splat(-2.) * outside * (ir * ir) * splat(R * R)) * splat(gauss_w[g]);
                  s += G;
                  const V dGx = dG * rx, dGy = dG * ry;
                  sax += splat(1. - gauss_x[g]) * dGx;
                  say += splat(1. - gauss_x[g]) * dGy;
                  sbx += splat(gauss_x[g]) * dGx;
                  sby += splat(gauss_x[g]) * dGy;
                  if (viscous)
                    {
                      const V w = positive(one - u), w2 = w * w, kernel = w2 * w2 * (four * u + one) * splat(gauss_w[g]);
                      wa += splat(1. - gauss_x[g]) * kernel;
                      wb += splat(gauss_x[g]) * kernel;
                    }
                }
              const double scale = 7. / (pi * R * R), scale_grad = scale * iR * iR;
              const V a2 = splat(1. / (2. * pi)) * reciprocal(ax * ax + ay * ay + tiny);
              const V b2 = splat(1. / (2. * pi)) * reciprocal(bx * bx + by * by + tiny);
              const V S = s * splat(scale);
              const V cg = cross * splat(scale_grad);
              const V zero = splat(0.);
              const V part = cross * S - angle(cross, dot) * splat(1. / (2. * pi));
              gamma += sum(select_less(lane, live, part, zero));
              Gradient &out = gradients[chunks];
              out.ax = select_less(lane, live, by * S + cg * sax - ay * a2, zero);
              out.ay = select_less(lane, live, cg * say - bx * S + ax * a2, zero);
              out.bx = select_less(lane, live, cg * sbx - ay * S + by * b2, zero);
              out.by = select_less(lane, live, ax * S + cg * sby - bx * b2, zero);
              if (viscous)
                {
                  // |integral of W over the face| / distance to its plane, split between its nodes;
                  // the tangent direction of the face
                  const V ilen = rsqrt(ex * ex + ey * ey + tiny), distance = cross * ilen;
                  const V least = splat(0.2 * R); // half a particle spacing
                  const V weight = splat(scale) * reciprocal(ilen * select_less(distance, least, least, distance));
                  slip[4 * chunks] = select_less(lane, live, wa * weight, zero);
                  slip[4 * chunks + 1] = select_less(lane, live, wb * weight, zero);
                  slip[4 * chunks + 2] = ex * ilen;
                  slip[4 * chunks + 3] = ey * ilen;
                }
            }
        }
      // Just outside the wall the winding number is 0, not the 1 that was assumed.
      if (gamma > 1. + 1e-3)
        {
          gamma -= 1.;
          ++c.crossed;
        }
      if (gamma < 0.02)
        gamma = 0.02;
      rho[i - begin] = c.mass * kernel_sum / gamma;
      c.gamma[i] = gamma;
    }
  first_chunk[end - begin] = chunks;
  c.eos(c.eos_data, end - begin, rho, pressure);
  for (std::uint32_t i = begin; i < end; ++i)
    {
      double *row = c.rows + std::size_t(i) * row_doubles;
      const double ig = 1. / c.gamma[i], ir = 1. / rho[i - begin], p = pressure[i - begin], volume = c.mass * ir;
      c.rho[i] = rho[i - begin];
      c.pressure[i] = p;
      row[4] = volume * p * ir * ig;
      row[5] = volume;
      row[6] = ig;
      row[7] = 0.;

      std::uint32_t chunk = first_chunk[i - begin];
      if (chunk < first_chunk[i - begin + 1])
        {
          const V b = splat(volume * p * ig);
          const double drag = 2. * c.viscosity * volume * ig;
          V fx = splat(0.), fy = splat(0.);
          for (std::uint32_t arc = c.first_arc[i]; arc < c.first_arc[i + 1]; ++arc)
            for (std::uint32_t k = 0; k < c.arcs[arc].count; k += W, ++chunk)
              {
                const std::uint32_t at = c.arcs[arc].first + k;
                const Gradient &g = gradients[chunk];
                V fax = b * g.ax, fay = b * g.ay, fbx = b * g.bx, fby = b * g.by;
                if (viscous)
                  {
                    const V tx = slip[4 * chunk + 2], ty = slip[4 * chunk + 3], vx = splat(row[2]), vy = splat(row[3]);
                    const V sa = splat(drag) * slip[4 * chunk]
                                 * ((vx - load(c.wall_v[0] + at)) * tx + (vy - load(c.wall_v[1] + at)) * ty);
                    const V sb = splat(drag) * slip[4 * chunk + 1]
                                 * ((vx - load(c.wall_v[0] + at + 1)) * tx + (vy - load(c.wall_v[1] + at + 1)) * ty);
                    fax += sa * tx;
                    fay += sa * ty;
                    fbx += sb * tx;
                    fby += sb * ty;
                  }
                store(c.wall_f[0] + at, load(c.wall_f[0] + at) + fax);
                store(c.wall_f[1] + at, load(c.wall_f[1] + at) + fay);
                store(c.wall_f_next[0] + at, load(c.wall_f_next[0] + at) + fbx);
                store(c.wall_f_next[1] + at, load(c.wall_f_next[1] + at) + fby);
                fx += fax + fbx;
                fy += fay + fby;
              }
          c.f[0][i] -= sum(fx);
          c.f[1][i] -= sum(fy);
        }
    }
  }
}

template <bool viscous>
void force(CellView &c)
{
  const double R = c.support, iR = 1. / R, C = 7. / (pi * R * R) / c.depth;
  const V viR = splat(iR), one = splat(1.), tiny = splat(1e-24 * R * R);
  // -20 C (1 - u)^3 / R^2 = W'/r
  const V slope = splat(-20. * C * iR * iR);
  const V mass = splat(c.mass);
  // chi mu_i mu_j / (mu_i + mu_j) = 16 mu / 2, times 1/2 from the mean of 1/gamma
  const double drag = 4. * c.viscosity;
  for (std::uint32_t i = 0; i < c.n; ++i)
    {
      const double *row = c.rows + std::size_t(i) * row_doubles;
      const V xi = splat(row[0]), yi = splat(row[1]), vxi = splat(row[2]), vyi = splat(row[3]), ai = splat(row[4]);
      const V Vi = splat(drag * row[5]), igi = splat(row[6]);
      V fx = splat(0.), fy = splat(0.);
      for (std::uint32_t k = c.first_neighbour[i]; k < c.first_neighbour[i + 1]; k += W)
        {
          V j[row_doubles];
          load_rows(c.rows, c.neighbours + k, j);
          const V dx = j[0] - xi, dy = j[1] - yi, r2 = dx * dx + dy * dy + tiny;
          const V ir = rsqrt(r2), u = r2 * ir * viR;
          const V w = positive(one - u), g = slope * (w * w * w);
          V coefficient = mass * (ai + j[4]);
          if (viscous)
            {
              const V approach = ((j[2] - vxi) * dx + (j[3] - vyi) * dy) * (ir * ir);
              coefficient -= Vi * j[5] * (igi + j[6]) * approach;
            }
          coefficient *= g;
          fx += coefficient * dx;
          fy += coefficient * dy;
        }
      c.f[0][i] += sum(fx);
      c.f[1][i] += sum(fy);
    }
}
void density_any(CellView &c)
{
  if (c.viscosity > 0.)
    density<true>(c);
  else
    density<false>(c);
}
void force_any(CellView &c)
{
  if (c.viscosity > 0.)
    force<true>(c);
  else
    force<false>(c);
}
} // namespace
} // namespace turgor::sph
