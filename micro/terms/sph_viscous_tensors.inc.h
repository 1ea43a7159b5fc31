// From a particle's moments S and Y to its tensor T (sph_viscosity.inc.h). Included by it alone and under its
// rule.
#pragma once

#include "micro/terms/sph_viscous_rows.inc.h"

namespace turgor::sph {
namespace {
/// Eigenvalues and (columns) eigenvectors of a symmetric matrix by Jacobi's rotations; `a` is overwritten.
template <int dim>
void eigen_decomposition(double a[dim][dim], double e[dim][dim]) {
  for (int k = 0; k < dim; ++k)
    for (int l = 0; l < dim; ++l) e[k][l] = k == l;
  for (int sweep = 0; sweep < 12; ++sweep)
    for (int p = 0; p < dim; ++p)
      for (int q = p + 1; q < dim; ++q) {
        if (a[p][q] == 0.) continue;
        const double theta = (a[q][q] - a[p][p]) / (2. * a[p][q]), size = theta < 0. ? -theta : theta,
                     t = (theta < 0. ? -1. : 1.) / (size + __builtin_sqrt(size * size + 1.)),
                     cos = 1. / __builtin_sqrt(t * t + 1.), sin = t * cos;
        for (int k = 0; k < dim; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = cos * kp - sin * kq;
          a[k][q] = sin * kp + cos * kq;
        }
        for (int k = 0; k < dim; ++k) {
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
inline void tensor_of(const Number inverse[dim][dim], const Number Y[dim][dim], const Number theta,
                      const Number beta, Number T[dim][dim]) {
  Number G[dim][dim], s[dim][dim], trace = theta - theta;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) {
      G[a][b] = Y[a][0] * inverse[0][b];
      for (int k = 1; k < dim; ++k) G[a][b] += Y[a][k] * inverse[k][b];
    }
  for (int a = 0; a < dim; ++a) trace += G[a][a];
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) s[a][b] = theta * (a == b ? G[a][b] + G[b][a] + trace : G[a][b] + G[b][a]);
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) {
      T[a][b] = -beta * G[a][b];
      for (int k = 0; k < dim; ++k) T[a][b] += s[a][k] * inverse[k][b];
    }
}

/// T of one particle whose S is small in some direction; returns 1 - theta.
template <int dim>
double thin_tensor(const double *moments, double *to) {
  double S[dim][dim], Y[dim][dim], e[dim][dim], inverse[dim][dim], T[dim][dim], least = 1e300;
  int at = 0;
  for (int a = 0; a < dim; ++a)
    for (int b = a; b < dim; ++b, ++at) S[a][b] = S[b][a] = moments[at];
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b, ++at) Y[a][b] = moments[at];
  eigen_decomposition<dim>(S, e);
  for (int k = 0; k < dim; ++k) {
    S[k][k] = S[k][k] < 0. ? 0. : S[k][k];
    least = S[k][k] < least ? S[k][k] : least;
  }
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) {
      inverse[a][b] = 0.;
      for (int k = 0; k < dim; ++k)
        inverse[a][b] += e[a][k] * e[b][k] / (S[k][k] > least_moment ? S[k][k] : least_moment);
    }
  const double share = least < sound_moment ? least / sound_moment : 1., theta = share * share;
  tensor_of<dim, double>(inverse, Y, theta, theta * residual_share, T);
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) to[dim * a + b] = T[a][b];
  return 1. - theta;
}

/// S^-1 of W particles by minors, and where S - sound_moment is positive (1) or not (0).
inline V invert(const V S[3], V inverse[2][2]) {
  const V zero = splat(0.), one = splat(1.), a = S[0] - splat(sound_moment), d = S[2] - splat(sound_moment);
  const V over = reciprocal(S[0] * S[2] - S[1] * S[1]);
  inverse[0][0] = S[2] * over;
  inverse[0][1] = inverse[1][0] = -S[1] * over;
  inverse[1][1] = S[0] * over;
  return select_less(zero, a, select_less(S[1] * S[1], a * d, one, zero), zero);
}
inline V invert(const V S[6], V inverse[3][3]) {
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
  return select_less(zero, S[0] - shift,
                     select_less(zero, less[5], select_less(zero, minor, one, zero), zero), zero);
}

/// T of all particles, from their moments into their rows; 1 - theta into the moments' last column. Whether
/// any particle is thin.
template <int dim>
bool find_tensors(CellView<dim> &c) {
  using Is = Viscous<dim>;
  bool thin = false;
  for (std::uint32_t i = 0; i < c.n; i += W) {
    std::uint16_t number[W];
    for (std::uint32_t l = 0; l < W; ++l) number[l] = std::uint16_t(i + l < c.n ? i + l : c.n - 1);
    V m[Is::row], inverse[dim][dim], Y[dim][dim], T[dim][dim];
    for (int k = 0; k < Is::row; k += 8) load_rows<Is::row>(c.moments + k, number, m + k);
    const V sound = invert(m, inverse);
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) Y[a][b] = m[Is::moment + dim * a + b];
    tensor_of<dim, V>(inverse, Y, splat(1.), splat(residual_share), T);
    alignas(64) double flat[dim * dim][W], good[W];
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) store(flat[dim * a + b], T[a][b]);
    store(good, sound);
    for (std::uint32_t l = 0; l < W && i + l < c.n; ++l) {
      double *to = c.viscous_rows + std::size_t(i + l) * Is::row + Is::tensor,
             *from = c.moments + std::size_t(i + l) * Is::row;
      from[Is::thin] = 0.;
      if (good[l] > 0.)
        for (int k = 0; k < dim * dim; ++k) to[k] = flat[k][l];
      else {
        from[Is::thin] = thin_tensor<dim>(from, to);
        thin = thin || from[Is::thin] > 0.;
      }
    }
  }
  return thin;
}
}  // namespace
}  // namespace turgor::sph
