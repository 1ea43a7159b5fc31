// Newton's viscosity of the fluid, 2D and 3D, by a velocity gradient per particle: exact for affine flow whatever the packing, for
// walls enter as further observations. Included by sph_sweeps.inc.h alone and under its rule: anonymous namespace, no inline
// function of a shared header.
//
// Of particle i, over its pairs and its points of the wall p, with r_p = x_p - x_i, v_p = v_p - v_i and everything over mu V:
//   pairs  w_ij = V |W'(r)|/r                                     V: the same for all particles of a cell
//   walls  w_iq = (2 N(s)/s) dOmega min(1, z/z_0),  N(s) = integral from s to R of |W'| r^(d-1) dr     (sph_viscous_edges.inc.h, ..._triangles)
//   S = sum w r (x) r,  Y = sum w v (x) r,  G = Y S^-1            least squares: exact if the flow is affine
//   s = G + G^T + tr G                                            Newton's stress with the bulk viscosity of Eq. 2.25
//   R = mu V sum_i { theta [D:D + (tr D)^2/2] + (beta/2) sum w |v - G r|^2 },  D = sym G        half the dissipated power
//   T = theta s S^-1 - beta G
//   pairs  F_i = mu V w_ij [2 beta v_ij + (T_i + T_j) r_ij]       = -dR/dv_i exactly: symmetric, never negative
//   walls  F_i = mu V w_iq [beta v_iq + T_i r_iq],                and -b_k F_i on node k, the point's share of it
// R depends on velocities by D and by residuals that an affine flow does not have: a rigid spin costs nothing, so both
// momenta are kept, though the forces are not central. beta = 4/3 takes away the error of order (k R)^2 of a shear wave: D alone
// misses (k r)^2/3 of it, the whole pair sum (k r)^2/12. The residual also resists every motion that D does not see.
// Where S is small in a direction (a torn cell) G cannot be known: theta = (least eigenvalue of S / 0.4)^2 fades the stress, and S is never
// made larger than it is, or a spin would cost.
#pragma once

#include "micro/terms/sph_pairs.inc.h"

namespace turgor::sph
{
namespace
{
constexpr double residual_share = 4. / 3.;        ///< beta
constexpr double sound_moment = 0.4;              ///< least eigenvalue of S from which on theta is 1
constexpr double least_moment = 1e-12;            ///< added to eigenvalues of S before division, where they are small
constexpr double viscous_reach = 0.2;             ///< z_0 over the support

/// Columns of a particle's viscous row and of its moments, both viscous_row<dim> doubles:
/// 2D: x y vx vy T;  3D: x y z vx vy vz T -.   S (upper triangle by rows) Y (by rows).
template <int dim>
struct Viscous
{
  static constexpr int velocity = dim, tensor = 2 * dim, moment = dim * (dim + 1) / 2, moments = moment + dim * dim;
  static constexpr int row = viscous_row<dim>;
};

/// Adds w r (x) r and w v (x) r.
template <int dim>
inline void add_moments(V sums[], const V w, const V r[], const V v[])
{
  V wr[dim];
  for (int a = 0; a < dim; ++a)
    wr[a] = w * r[a];
  int k = 0;
  for (int a = 0; a < dim; ++a)
    for (int b = a; b < dim; ++b, ++k)
      sums[k] += wr[a] * r[b];
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b, ++k)
      sums[k] += v[a] * wr[b];
}

/// Positions and velocities in the rows; the row that pads the lists is out of reach.
template <int dim>
void fill_viscous_rows(CellView<dim> &c)
{
  constexpr int size = Viscous<dim>::row;
  for (std::uint32_t i = 0; i < c.n; ++i)
    {
      double *row = c.viscous_rows + std::size_t(i) * size;
      for (int d = 0; d < dim; ++d)
        {
          row[d] = c.x[d][i];
          row[Viscous<dim>::velocity + d] = c.v[d][i];
        }
      for (int k = Viscous<dim>::tensor; k < size; ++k)
        row[k] = 0.;
    }
  double *dummy = c.viscous_rows + std::size_t(c.n) * size;
  for (int k = 0; k < size; ++k)
    dummy[k] = k < dim ? c.x[k][0] + 1e3 * c.support : 0.;
}

/// w of pairs over (1 - u)^3.
template <int dim>
inline double pair_weight(const CellView<dim> &c)
{
  return 20. * Kernel<dim, false>::peak(c.support) / c.depth * c.particle_volume / (c.support * c.support);
}

/// S and Y of the pairs.
template <int dim>
void sum_moments(CellView<dim> &c)
{
  using Is = Viscous<dim>;
  const double R = c.support;
  const V viR = splat(1. / R), one = splat(1.), tiny = splat(1e-24 * R * R), weight = splat(pair_weight(c));
  for (std::uint32_t i = 0; i < c.n; ++i)
    {
      const double *row = c.viscous_rows + std::size_t(i) * Is::row;
      V xi[dim], vi[dim], total[Is::row];
      for (int d = 0; d < dim; ++d)
        {
          xi[d] = splat(row[d]);
          vi[d] = splat(row[Is::velocity + d]);
        }
      for (V &sum : total)
        sum = splat(0.);
      const std::uint32_t begin = c.first_neighbour[i], end = list_end(c.neighbours, begin, c.first_neighbour[i + 1], c.n);
      for (std::uint32_t k = begin; k < end; k += W)
        {
          V j[8], v[dim];
          if constexpr (dim == 2)
            load_half_rows<Is::row>(c.viscous_rows, c.neighbours + k, j);
          else
            load_rows<Is::row>(c.viscous_rows, c.neighbours + k, j);
          const V w = positive(one - root(square_from<dim>(xi, j, tiny)) * viR);
          for (int d = 0; d < dim; ++d)
            v[d] = j[Is::velocity + d] - vi[d];
          add_moments<dim>(total, w * w * w, j, v);
        }
      double *to = c.moments + std::size_t(i) * Is::row;
      for (int k = 0; k < Is::row; k += 8)
        {
          for (int l = k; l < k + 8; ++l)
            total[l] *= weight;
          sums_of_eight(total + k, to + k);
        }
    }
}

/// Eigenvalues and (columns) eigenvectors of a symmetric matrix by Jacobi's rotations; `a` is overwritten.
template <int dim>
void eigen_decomposition(double a[dim][dim], double e[dim][dim])
{
  for (int k = 0; k < dim; ++k)
    for (int l = 0; l < dim; ++l)
      e[k][l] = k == l;
  for (int sweep = 0; sweep < 12; ++sweep)
    for (int p = 0; p < dim; ++p)
      for (int q = p + 1; q < dim; ++q)
        {
          if (a[p][q] == 0.)
            continue;
          const double theta = (a[q][q] - a[p][p]) / (2. * a[p][q]), size = theta < 0. ? -theta : theta,
                       t = (theta < 0. ? -1. : 1.) / (size + __builtin_sqrt(size * size + 1.)), cos = 1. / __builtin_sqrt(t * t + 1.),
                       sin = t * cos;
          for (int k = 0; k < dim; ++k)
            {
              const double kp = a[k][p], kq = a[k][q];
              a[k][p] = cos * kp - sin * kq;
              a[k][q] = sin * kp + cos * kq;
            }
          for (int k = 0; k < dim; ++k)
            {
              const double pk = a[p][k], qk = a[q][k], kp = e[k][p], kq = e[k][q];
              a[p][k] = cos * pk - sin * qk;
              a[q][k] = sin * pk + cos * qk;
              e[k][p] = cos * kp - sin * kq;
              e[k][q] = sin * kp + cos * kq;
            }
          a[p][q] = a[q][p] = 0.;
        }
}

/// T from S^-1, Y and theta; numbers or lanes.
template <int dim, typename Number>
inline void tensor_of(const Number inverse[dim][dim], const Number Y[dim][dim], const Number theta, const Number beta, Number T[dim][dim])
{
  Number G[dim][dim], s[dim][dim], trace = theta - theta;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      {
        G[a][b] = Y[a][0] * inverse[0][b];
        for (int k = 1; k < dim; ++k)
          G[a][b] += Y[a][k] * inverse[k][b];
      }
  for (int a = 0; a < dim; ++a)
    trace += G[a][a];
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      s[a][b] = theta * (a == b ? G[a][b] + G[b][a] + trace : G[a][b] + G[b][a]);
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      {
        T[a][b] = -beta * G[a][b];
        for (int k = 0; k < dim; ++k)
          T[a][b] += s[a][k] * inverse[k][b];
      }
}

/// T of one particle whose S is small in some direction.
template <int dim>
void thin_tensor(const double *moments, double *to)
{
  double S[dim][dim], Y[dim][dim], e[dim][dim], inverse[dim][dim], T[dim][dim], least = 1e300;
  int at = 0;
  for (int a = 0; a < dim; ++a)
    for (int b = a; b < dim; ++b, ++at)
      S[a][b] = S[b][a] = moments[at];
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b, ++at)
      Y[a][b] = moments[at];
  eigen_decomposition<dim>(S, e);
  for (int k = 0; k < dim; ++k)
    {
      S[k][k] = S[k][k] < 0. ? 0. : S[k][k];
      least = S[k][k] < least ? S[k][k] : least;
    }
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      {
        inverse[a][b] = 0.;
        for (int k = 0; k < dim; ++k)
          inverse[a][b] += e[a][k] * e[b][k] / (S[k][k] + least_moment);
      }
  const double share = least < sound_moment ? least / sound_moment : 1.;
  tensor_of<dim, double>(inverse, Y, share * share, residual_share, T);
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      to[dim * a + b] = T[a][b];
}

/// S^-1 of W particles by minors, and where S - sound_moment is positive (1) or not (0).
inline V invert(const V S[3], V inverse[2][2])
{
  const V zero = splat(0.), one = splat(1.), a = S[0] - splat(sound_moment), d = S[2] - splat(sound_moment);
  const V over = reciprocal(S[0] * S[2] - S[1] * S[1]);
  inverse[0][0] = S[2] * over;
  inverse[0][1] = inverse[1][0] = -S[1] * over;
  inverse[1][1] = S[0] * over;
  return select_less(zero, a, select_less(S[1] * S[1], a * d, one, zero), zero);
}
inline V invert(const V S[6], V inverse[3][3])
{
  const auto cofactors = [](const V &a, const V &b, const V &c, const V &d, const V &e, const V &f, V m[6]) {
    m[0] = d * f - e * e;
    m[1] = c * e - b * f;
    m[2] = b * e - c * d;
    m[3] = a * f - c * c;
    m[4] = b * c - a * e;
    m[5] = a * d - b * b;
    return a * m[0] + b * m[1] + c * m[2];
  };
  const V zero = splat(0.), one = splat(1.), shift = splat(sound_moment);
  V m[6], less[6];
  const V over = reciprocal(cofactors(S[0], S[1], S[2], S[3], S[4], S[5], m));
  const V minor = cofactors(S[0] - shift, S[1], S[2], S[3] - shift, S[4], S[5] - shift, less);
  inverse[0][0] = m[0] * over;
  inverse[0][1] = inverse[1][0] = m[1] * over;
  inverse[0][2] = inverse[2][0] = m[2] * over;
  inverse[1][1] = m[3] * over;
  inverse[1][2] = inverse[2][1] = m[4] * over;
  inverse[2][2] = m[5] * over;
  return select_less(zero, S[0] - shift, select_less(zero, less[5], select_less(zero, minor, one, zero), zero), zero);
}

/// T of all particles, from their moments into their rows.
template <int dim>
void find_tensors(CellView<dim> &c)
{
  using Is = Viscous<dim>;
  for (std::uint32_t i = 0; i < c.n; i += W)
    {
      std::uint16_t number[W];
      for (std::uint32_t l = 0; l < W; ++l)
        number[l] = std::uint16_t(i + l < c.n ? i + l : c.n - 1);
      V m[Is::row], inverse[dim][dim], Y[dim][dim], T[dim][dim];
      for (int k = 0; k < Is::row; k += 8)
        load_rows<Is::row>(c.moments + k, number, m + k);
      const V sound = invert(m, inverse);
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b)
          Y[a][b] = m[Is::moment + dim * a + b];
      tensor_of<dim, V>(inverse, Y, splat(1.), splat(residual_share), T);
      alignas(64) double flat[dim * dim][W], good[W];
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b)
          store(flat[dim * a + b], T[a][b]);
      store(good, sound);
      for (std::uint32_t l = 0; l < W && i + l < c.n; ++l)
        {
          double *to = c.viscous_rows + std::size_t(i + l) * Is::row + Is::tensor;
          if (good[l] > 0.)
            for (int k = 0; k < dim * dim; ++k)
              to[k] = flat[k][l];
          else
            thin_tensor<dim>(c.moments + std::size_t(i + l) * Is::row, to);
        }
    }
}

/// The forces between particles.
template <int dim>
void drag_pairs(CellView<dim> &c)
{
  using Is = Viscous<dim>;
  const double R = c.support, scale = c.viscosity * c.particle_volume * pair_weight(c);
  const V viR = splat(1. / R), one = splat(1.), tiny = splat(1e-24 * R * R), twice = splat(2. * residual_share);
  for (std::uint32_t i = 0; i < c.n; ++i)
    {
      const double *row = c.viscous_rows + std::size_t(i) * Is::row;
      V own[Is::tensor + dim * dim], total[dim];
      for (int k = 0; k < Is::tensor + dim * dim; ++k)
        own[k] = splat(row[k]);
      for (V &sum : total)
        sum = splat(0.);
      const std::uint32_t begin = c.first_neighbour[i], end = list_end(c.neighbours, begin, c.first_neighbour[i + 1], c.n);
      for (std::uint32_t k = begin; k < end; k += W)
        {
          V j[Is::row];
          for (int part = 0; part < Is::row; part += 8)
            load_rows<Is::row>(c.viscous_rows + part, c.neighbours + k, j + part);
          const V w = positive(one - root(square_from<dim>(own, j, tiny)) * viR), w3 = w * w * w;
          for (int a = 0; a < dim; ++a)
            {
              V pull = twice * (j[Is::velocity + a] - own[Is::velocity + a]);
              for (int b = 0; b < dim; ++b)
                pull += (own[Is::tensor + dim * a + b] + j[Is::tensor + dim * a + b]) * j[b];
              total[a] += w3 * pull;
            }
        }
      double f[dim];
      sums<dim>(total, f);
      for (int d = 0; d < dim; ++d)
        c.f[d][i] += scale * f[d];
    }
}

// The wall's part: sph_viscous_edges.inc.h and
void add_wall_moments(CellView<2> &c);
void drag_wall(CellView<2> &c);
// sph_viscous_triangles.inc.h
void add_wall_moments(CellView<3> &c);
void drag_wall(CellView<3> &c);

/// Adds the viscous forces; lists, wall and velocities as for density() and force().
template <int dim>
void viscosity(CellView<dim> &c)
{
  fill_viscous_rows<dim>(c);
  sum_moments<dim>(c);
  add_wall_moments(c);
  find_tensors<dim>(c);
  drag_pairs<dim>(c);
  drag_wall(c);
}
} // namespace
} // namespace turgor::sph
