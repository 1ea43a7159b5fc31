// The viscosity of particles with too few neighbours for a velocity gradient (sph_viscosity.inc.h): the share
// 1 - theta of
//   R_i = mu V ((d + 2)/2) sum w (v . r/|r|)^2,   F_i = mu V (d + 2) w r (r . v)/r^2 for each neighbour or
//     point of the wall.
// Central forces: a spin costs nothing and turns nothing, whatever the neighbours are. Over an isotropic
// neighbourhood (sum w r (x) r = 1) the sum is [2 D:D + (tr D)^2]/(d + 2), Newton's. Included by
// sph_viscosity.inc.h alone and under its rule.
#pragma once

#include "micro/terms/sph_viscous_rows.inc.h"

namespace turgor::sph {
namespace {
template <int dim>
constexpr double central_share = dim + 2.;

/// What drag_pairs() has given thin particles for their own part of R in full, beta v, becomes theta of it
/// and 1 - theta of the central one.
template <int dim>
void drag_thin_pairs(CellView<dim> &c) {
  using Is = Viscous<dim>;
  const double R = c.support, scale = c.viscosity * c.particle_volume * pair_weight(c);
  for (std::uint32_t i = 0; i < c.n; ++i) {
    const double share = c.moments[std::size_t(i) * Is::row + Is::thin],
                 *own = c.viscous_rows + std::size_t(i) * Is::row;
    if (!(share > 0.)) continue;
    for (std::uint32_t k = c.first_neighbour[i]; k < c.first_neighbour[i + 1]; ++k) {
      const std::uint32_t j = c.neighbours[k];
      if (j >= c.n) continue;
      const double *other = c.viscous_rows + std::size_t(j) * Is::row;
      double r[dim], v[dim], r2 = 1e-24 * R * R, rate = 0.;
      for (int d = 0; d < dim; ++d) {
        r[d] = other[d] - own[d];
        v[d] = other[Is::velocity + d] - own[Is::velocity + d];
        r2 += r[d] * r[d];
        rate += r[d] * v[d];
      }
      const double w = 1. - __builtin_sqrt(r2) / R;
      if (!(w > 0.)) continue;
      const double weight = scale * share * w * w * w, central = central_share<dim> * rate / r2;
      for (int d = 0; d < dim; ++d) {
        const double f = weight * (central * r[d] - residual_share * v[d]);
        c.f[d][i] += f;
        c.f[d][j] -= f;
      }
    }
  }
}

/// The central part along a particle's rays to a face: f[k] += on the particle, through corner k, over share
/// mu V. m: sum of w b_k b_l over the rays' points, by rows of the upper triangle. As many points with other
/// shares have the same sum (m = L D L^T: the columns of L, weights D); forces along them are central as
/// well.
template <int dim>
inline void drag_thin_rays(const CellView<dim> &c, const V m[], const V r[dim][dim], const V v[dim][dim],
                           V f[dim][dim]) {
  const V zero = splat(0.), R2 = splat(c.support * c.support), least = splat(1e-290),
          tiny = splat(1e-24) * R2;
  V M[dim][dim], L[dim][dim];
  for (int k = 0, at = 0; k < dim; ++k)
    for (int l = k; l < dim; ++l, ++at) M[k][l] = M[l][k] = m[at];
  for (int k = 0; k < dim; ++k) {
    // what is left of a diagonal may be round-off: it does not count beside what was there
    const V weight = positive(M[k][k]), over = reciprocal(weight +
                                                          splat(1e-12) * m[k == 0   ? 0
                                                                           : k == 1 ? dim
                                                                                    : 5] +
                                                          least);
    for (int l = k + 1; l < dim; ++l) L[l][k] = M[l][k] * over;
    for (int a = k + 1; a < dim; ++a)
      for (int b = k + 1; b < dim; ++b) M[a][b] -= L[a][k] * M[k][b];
    V at[dim], speed[dim], rate = zero, square = tiny;
    for (int d = 0; d < dim; ++d) {
      at[d] = r[k][d];
      speed[d] = v[k][d];
      for (int l = k + 1; l < dim; ++l) {
        at[d] += L[l][k] * r[l][d];
        speed[d] += L[l][k] * v[l][d];
      }
      rate += at[d] * speed[d];
      square += at[d] * at[d];
    }
    const V strength = splat(central_share<dim>) * weight * rate * reciprocal(square);
    for (int d = 0; d < dim; ++d) {
      const V g = strength * at[d];
      f[k][d] += g;
      for (int l = k + 1; l < dim; ++l) f[l][d] += L[l][k] * g;
    }
  }
}
}  // namespace
}  // namespace turgor::sph
