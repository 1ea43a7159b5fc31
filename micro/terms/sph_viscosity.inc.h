// Newton's viscosity of the fluid, 2D and 3D, by a velocity gradient per particle: exact for affine flow
// whatever the packing, for walls enter as further observations. Included by sph_sweeps.inc.h alone and under
// its rule: anonymous namespace, no inline function of a shared header.
//
// Of particle i, over its pairs and its points of the wall p, with r_p = x_p - x_i, v_p = v_p - v_i and
// everything over mu V:
//   pairs  w_ij = V |W'(r)|/r                                     V: the same for all particles of a cell
//   walls  w_iq = (2 N(s)/s) dOmega min(1, z/z_0),  N(s) = integral from s to R of |W'| r^(d-1) dr
//          (sph_viscous_edges.inc.h, ..._triangles)
//   S = sum w r (x) r,  Y = sum w v (x) r,  G = Y S^-1            least squares: exact if the flow is affine
//   s = G + G^T + tr G                                            Newton's stress with the bulk viscosity of
//     Eq. 2.25
//   R = mu V sum_i { theta [D:D + (tr D)^2/2 + (beta/2) sum w |v - G r|^2] + (1 - theta) ((d + 2)/2) sum w (v
//     . r/|r|)^2 },  D = sym G
//   T = theta (s S^-1 - beta G)                                                                    R: half
//   the dissipated power
//   pairs  F_i = mu V w_ij [2 beta v_ij + (T_i + T_j) r_ij]       = -dR/dv_i exactly: symmetric, never
//          negative
//   walls  F_i = mu V w_iq [beta v_iq + T_i r_iq],                and -b_k F_i on node k, the point's share
//          of it       (theta = 1)
// R depends on velocities by D and by residuals that an affine flow does not have: a rigid spin costs
// nothing, so both momenta are kept, though the forces are not central. beta = 4/3 takes away the error of
// order (k R)^2 of a shear wave: D alone misses (k r)^2/3 of it, the whole pair sum (k r)^2/12. The residual
// also resists every motion that D does not see. Where S is small in a direction (a torn cell) G cannot be
// known: its error is round-off over that eigenvalue. theta, the least eigenvalue of S over 0.4, squared,
// fades both terms before that matters, and Monaghan's central drag takes their place
// (sph_viscous_thin.inc.h): it needs no inverse, and of what it has in an isotropic neighbourhood Newton's
// stress follows as well. S is never made larger than it is, or a spin would cost.
#pragma once

#include "micro/terms/sph_viscous_tensors.inc.h"
#include "micro/terms/sph_viscous_thin.inc.h"

namespace turgor::sph {
namespace {
/// S and Y of the pairs.
template <int dim>
void sum_moments(CellView<dim> &c) {
  using Is = Viscous<dim>;
  const double R = c.support;
  const V viR = splat(1. / R), one = splat(1.), tiny = splat(1e-24 * R * R), weight = splat(pair_weight(c));
  for (std::uint32_t i = 0; i < c.n; ++i) {
    const double *row = c.viscous_rows + std::size_t(i) * Is::row;
    V xi[dim], vi[dim], total[Is::row];
    for (int d = 0; d < dim; ++d) {
      xi[d] = splat(row[d]);
      vi[d] = splat(row[Is::velocity + d]);
    }
    for (V &sum : total) sum = splat(0.);
    const std::uint32_t begin = c.first_neighbour[i],
                        end = list_end(c.neighbours, begin, c.first_neighbour[i + 1], c.n);
    for (std::uint32_t k = begin; k < end; k += W) {
      V j[8], v[dim];
      if constexpr (dim == 2)
        load_half_rows<Is::row>(c.viscous_rows, c.neighbours + k, j);
      else
        load_rows<Is::row>(c.viscous_rows, c.neighbours + k, j);
      const V w = positive(one - root(square_from<dim>(xi, j, tiny)) * viR);
      for (int d = 0; d < dim; ++d) v[d] = j[Is::velocity + d] - vi[d];
      add_moments<dim>(total, w * w * w, j, v);
    }
    double *to = c.moments + std::size_t(i) * Is::row;
    for (int k = 0; k < Is::row; k += 8) {
      for (int l = k; l < k + 8; ++l) total[l] *= weight;
      sums_of_eight(total + k, to + k);
    }
  }
}

/// The forces between particles.
template <int dim>
void drag_pairs(CellView<dim> &c) {
  using Is = Viscous<dim>;
  const double R = c.support, scale = c.viscosity * c.particle_volume * pair_weight(c);
  const V viR = splat(1. / R), one = splat(1.), tiny = splat(1e-24 * R * R),
          twice = splat(2. * residual_share);
  for (std::uint32_t i = 0; i < c.n; ++i) {
    const double *row = c.viscous_rows + std::size_t(i) * Is::row;
    V own[Is::tensor + dim * dim], total[dim];
    for (int k = 0; k < Is::tensor + dim * dim; ++k) own[k] = splat(row[k]);
    for (V &sum : total) sum = splat(0.);
    const std::uint32_t begin = c.first_neighbour[i],
                        end = list_end(c.neighbours, begin, c.first_neighbour[i + 1], c.n);
    for (std::uint32_t k = begin; k < end; k += W) {
      V j[Is::row];
      for (int part = 0; part < Is::row; part += 8)
        load_rows<Is::row>(c.viscous_rows + part, c.neighbours + k, j + part);
      const V w = positive(one - root(square_from<dim>(own, j, tiny)) * viR), w3 = w * w * w;
      for (int a = 0; a < dim; ++a) {
        V pull = twice * (j[Is::velocity + a] - own[Is::velocity + a]);
        for (int b = 0; b < dim; ++b)
          pull += (own[Is::tensor + dim * a + b] + j[Is::tensor + dim * a + b]) * j[b];
        total[a] += w3 * pull;
      }
    }
    double f[dim];
    sums<dim>(total, f);
    for (int d = 0; d < dim; ++d) c.f[d][i] += scale * f[d];
  }
}

// The wall's part: sph_viscous_edges.inc.h and
void add_wall_moments(CellView<2> &c);
void drag_wall(CellView<2> &c, bool thin);
// sph_viscous_triangles.inc.h
void add_wall_moments(CellView<3> &c);
void drag_wall(CellView<3> &c, bool thin);

/// Adds the viscous forces; lists, wall and velocities as for density() and force().
template <int dim>
void viscosity(CellView<dim> &c) {
  fill_viscous_rows<dim>(c);
  sum_moments<dim>(c);
  add_wall_moments(c);
  const bool thin = find_tensors<dim>(c);
  drag_pairs<dim>(c);
  if (thin) drag_thin_pairs<dim>(c);
  drag_wall(c, thin);
}
}  // namespace
}  // namespace turgor::sph
