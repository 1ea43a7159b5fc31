// What the parts of sph_viscosity.inc.h share: its numbers and its rows. Included by them alone and under
// their rule: anonymous namespace, no inline function of a shared header.
#pragma once

#include "micro/terms/sph_pairs.inc.h"

namespace turgor::sph {
namespace {
constexpr double residual_share = 4. / 3.;  ///< beta
constexpr double sound_moment = 0.4;        ///< least eigenvalue of S from which on theta is 1
constexpr double least_moment =
    1e-30;  ///< eigenvalues of S count as no less in a division; theta is 0 long before
constexpr double viscous_reach = 0.2;  ///< z_0 over the support

/// Columns of a particle's viscous row and of its moments, both viscous_row<dim> doubles:
/// 2D: x y vx vy T;  3D: x y z vx vy vz T -.   S (upper triangle by rows) Y (by rows), then 1 - theta.
template <int dim>
struct Viscous {
  static constexpr int velocity = dim, tensor = 2 * dim, moment = dim * (dim + 1) / 2,
                       moments = moment + dim * dim;
  static constexpr int row = viscous_row<dim>, thin = moments;
  static_assert(moments + 1 == row);
};

/// Adds w r (x) r and w v (x) r.
template <int dim>
inline void add_moments(V sums[], const V w, const V r[], const V v[]) {
  V wr[dim];
  for (int a = 0; a < dim; ++a) wr[a] = w * r[a];
  int k = 0;
  for (int a = 0; a < dim; ++a)
    for (int b = a; b < dim; ++b, ++k) sums[k] += wr[a] * r[b];
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b, ++k) sums[k] += v[a] * wr[b];
}

/// Positions and velocities in the rows; the row that pads the lists is out of reach.
template <int dim>
void fill_viscous_rows(CellView<dim> &c) {
  constexpr int size = Viscous<dim>::row;
  for (std::uint32_t i = 0; i < c.n; ++i) {
    double *row = c.viscous_rows + std::size_t(i) * size;
    for (int d = 0; d < dim; ++d) {
      row[d] = c.x[d][i];
      row[Viscous<dim>::velocity + d] = c.v[d][i];
    }
    for (int k = Viscous<dim>::tensor; k < size; ++k) row[k] = 0.;
  }
  double *dummy = c.viscous_rows + std::size_t(c.n) * size;
  for (int k = 0; k < size; ++k) dummy[k] = k < dim ? c.x[k][0] + 1e3 * c.support : 0.;
}

/// w of pairs over (1 - u)^3.
template <int dim>
inline double pair_weight(const CellView<dim> &c) {
  return 20. * Kernel<dim, false>::peak(c.support) / c.depth * c.particle_volume / (c.support * c.support);
}
}  // namespace
}  // namespace turgor::sph
