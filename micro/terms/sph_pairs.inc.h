// The part of the sweeps of sph_sweeps.h that 2D and 3D share line by line: rows, kernel sums, law, pair
// forces. Included by sph_sweeps.inc.h alone and under its rule: anonymous namespace, no inline function of a
// shared header.
#pragma once

#include "micro/terms/sph_kernels.inc.h"

namespace turgor::sph {
namespace {
/// Sum of value(0 .. n - 1), in eight interleaved parts: an order that does not depend on the machine.
template <typename Value>
inline double sum_of(const std::uint32_t n, const Value &value) {
  double parts[8] = {};
  std::uint32_t i = 0;
  for (; i + 8 <= n; i += 8)
    for (std::uint32_t l = 0; l < 8; ++l) parts[l] += value(i + l);
  for (; i < n; ++i) parts[0] += value(i);
  return ((parts[0] + parts[4]) + (parts[1] + parts[5])) + ((parts[2] + parts[6]) + (parts[3] + parts[7]));
}

/// The row that pads the lists.
template <int dim>
inline std::uint32_t padding_row(const CellView<dim> &c) {
  return c.n + c.ghosts;
}

/// Positions, a row a particle or image, and the row that pads the lists: out of reach.
template <int dim>
void fill_rows(CellView<dim> &c) {
  const std::uint32_t all = padding_row(c);
  for (std::uint32_t i = 0; i < all; ++i) {
    double *row = c.rows + std::size_t(i) * row_doubles;
    for (int d = 0; d < dim; ++d) row[d] = c.x[d][i];
  }
  double *dummy = c.rows + std::size_t(all) * row_doubles;
  for (unsigned int k = 0; k < row_doubles; ++k) dummy[k] = k < dim ? c.x[k][0] + 1e3 * c.support : 0.;
}

/// |r|^2, never 0; r becomes the vectors from xi.
template <int dim>
inline V square_from(const V xi[dim], V r[], const V tiny) {
  V r2 = tiny;
  for (int d = 0; d < dim; ++d) {
    r[d] = r[d] - xi[d];
    r2 = r2 + r[d] * r[d];
  }
  return r2;
}

/// Where the list of a particle ends for W lanes: without what only pads it to list_padding.
inline std::uint32_t list_end(const std::uint16_t *neighbours, const std::uint32_t begin,
                              const std::uint32_t end, const std::uint32_t n) {
  return W < list_padding && end > begin && neighbours[end - W] == n ? end - W : end;
}

/// Kernel sums: rho but for gamma and scale.
template <int dim, bool fourth_order>
void sum_kernels(CellView<dim> &c) {
  using K = Kernel<dim, fourth_order>;
  const double R = c.support, iR = 1. / R, C = K::peak(R) / c.depth;
  const V viR = splat(iR), one = splat(1.), tiny = splat(1e-24 * R * R);
  std::uint32_t k = c.first_neighbour[0];
  for (std::uint32_t i = 0; i < c.n; ++i) {
    const double *row = c.rows + std::size_t(i) * row_doubles;
    V xi[dim];
    for (int d = 0; d < dim; ++d) xi[d] = splat(row[d]);
    V acc = splat(0.);
    const std::uint32_t next = c.first_neighbour[i + 1],
                        end = list_end(c.neighbours, k, next, padding_row(c));
    for (; k < end; k += W) {
      V r[4];
      if constexpr (dim == 2)
        load_two_columns<row_doubles>(c.rows, c.neighbours + k, r);
      else
        load_half_rows<row_doubles>(c.rows, c.neighbours + k, r);
      acc += K::value(positive(one - root(square_from<dim>(xi, r, tiny)) * viR));
    }
    k = next;
    c.rho[i] = c.mass * C * (1. + sum(acc));
  }
}

/// From the kernel sum and what the wall's formula gives: gamma, the density before scaling, and (in push)
/// the slope with which gamma follows the formula.
template <int dim, bool fourth_order>
inline void correct(CellView<dim> &c, const std::uint32_t i, double gamma) {
  double side = 1.;
  if (c.open) {
    if (gamma > 1.5) gamma -= 1.;  // where a crumpled wall laps over itself
    if (gamma > 1.) {
      gamma = 2. - gamma;
      side = -1.;
    }
    if (gamma < 0.5) {  // folds of a torn wall: see sph_sweeps.h
      side *= __builtin_exp((gamma - 0.5) / 0.1);
      gamma = 0.4 + 0.1 * (side < 0. ? -side : side);
    }
  } else if (gamma > (fourth_order ? 1.2 : 1. + 1e-3))  // W* itself goes up to 1.04 before a flat wall
  {  // Just outside the wall the winding number is 0, not the 1 that was assumed.
    gamma -= 1.;
    ++c.crossed;
  }
  if (gamma < 0.02) gamma = 0.02;
  double image_slope = 0.;
  if (c.layer_square > 0.) {  // its own image behind the wall
    const double peak = c.mass * Kernel<dim, fourth_order>::peak(c.support) / c.depth,
                 q = gamma > 0.5 ? 1. - gamma : 0.5;
    double x = q * (c.layer_linear + c.layer_square * q),
           slope = gamma > 0.5 ? -c.layer_linear - 2. * c.layer_square * q : 0.;
    if (x > 0.) {
      const double bound = 1. / (1. + 4. * x);
      x *= bound;
      slope *= bound * bound;
    }
    c.rho[i] += peak * x;
    image_slope = peak * slope;
  }
  c.rho[i] /= gamma;
  side *= 1. - image_slope / c.rho[i];
  c.gamma[i] = gamma;
  c.push[i] = side;
}

/// rho so that the volumes fill the cell, p, and their share in the rows.
template <int dim>
void apply_law(CellView<dim> &c) {
  double scale = c.scale, mean_pressure = 0.;
  if (c.volume > 0.) scale = c.mass * sum_of(c.n, [&](std::uint32_t i) { return 1. / c.rho[i]; }) / c.volume;
  for (std::uint32_t i = 0; i < c.n; ++i) c.rho[i] *= scale;
  c.eos(c.eos_data, c.n, c.rho, c.pressure);
  if (c.volume > 0.)
    mean_pressure =
        c.mass * sum_of(c.n, [&](std::uint32_t i) { return c.pressure[i] / c.rho[i]; }) / c.volume;
  c.mean_pressure = mean_pressure;
  c.scale = scale;
  for (std::uint32_t i = 0; i < c.n; ++i) {
    double *row = c.rows + std::size_t(i) * row_doubles;
    const double ig = 1. / c.gamma[i], ir = 1. / c.rho[i],
                 p = c.pressure[i] - mean_pressure + c.ordering * scale, volume = c.mass * ir;
    row[Column<dim>::a] = volume * p * scale * ir * ig;
    c.push[i] *= volume * p * ig;
  }
  for (std::uint32_t g = 0; g < c.ghosts; ++g)
    c.rows[std::size_t(c.n + g) * row_doubles + Column<dim>::a] =
        c.rows[std::size_t(c.ghost_of[g]) * row_doubles + Column<dim>::a];
}

template <int dim, bool fourth_order>
void force(CellView<dim> &c) {
  using Is = Column<dim>;
  using K = Kernel<dim, fourth_order>;
  const double R = c.support, iR = 1. / R, C = Kernel<dim, false>::peak(R) / c.depth;
  const V viR = splat(iR), one = splat(1.), tiny = splat(1e-24 * R * R);
  // W'/r = -20 C slope / R^2: common to all pairs, and put in at the end
  const double slope = -20. * C * iR * iR * c.mass;
  std::uint32_t k = c.first_neighbour[0];
  for (std::uint32_t i = 0; i < c.n; ++i) {
    const double *row = c.rows + std::size_t(i) * row_doubles;
    V xi[dim], total[dim];
    for (int d = 0; d < dim; ++d) {
      xi[d] = splat(row[d]);
      total[d] = splat(0.);
    }
    const V ai = splat(row[Is::a]);
    const std::uint32_t next = c.first_neighbour[i + 1],
                        end = list_end(c.neighbours, k, next, padding_row(c));
    for (; k < end; k += W) {
      V j[row_doubles];
      load_half_rows<row_doubles>(c.rows, c.neighbours + k, j);
      const V r2 = square_from<dim>(xi, j, tiny);
      const V w = positive(one - root(r2) * viR);
      V coefficient = ai + j[Is::a];
      coefficient *= fourth_order ? splat(K::alpha) * K::slope(w) : K::slope(w);
      for (int d = 0; d < dim; ++d) total[d] += coefficient * j[d];
    }
    k = next;
    double f[dim];
    sums<dim>(total, f);
    for (int d = 0; d < dim; ++d) c.f[d][i] += slope * f[d];
  }
}
}  // namespace
}  // namespace turgor::sph
