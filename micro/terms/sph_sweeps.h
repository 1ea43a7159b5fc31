// The two hot sweeps of the fluid in one closed cell, over plain arrays, compiled once
// per instruction set and chosen at run time (sph_sweeps_avx2.cc, sph_sweeps_avx512.cc).
//
// Formulation: variational, wall-corrected summation density. For fluid particle i of the cell
//   gamma_i = integral over the cell of W(|x - x_i|)       (share of the kernel inside the wall)
//   rho_i   = (m / gamma_i) sum_j W_ij                     (self included)
//   E       = sum_i m e(rho_i)
//   f_k     = - sum_i m p_i / rho_i^2 d rho_i / d x_k      for fluid and wall alike
// gamma from the wall alone: gamma_i = 1 + sum_faces [ integral G(r) r.n dS - angle / (2 pi) ],
// div(r G) = W, by 3-point Gauss on the face; the discrete expression itself is differentiated,
// so F = -dE/dx and momentum hold to round-off (compare Ferrand et al. 2013,
// 10.1002/fld.3666, for the continuous correction).
// Kernel: Wendland C2 (no pairing instability), W = C (1 - u)^4 (4 u + 1), u = r / support.
// Viscosity (thesis Eq. 2.25, corrected, chi = 16): central pair drag, renormalised by
// (1/gamma_i + 1/gamma_j)/2 at the wall, and no slip against the wall's faces.
#pragma once

#include <cstdint>

namespace turgor::sph
{
/// Consecutive wall faces [first, first + count) within reach of a particle; face k joins
/// ring nodes k and k + 1 (modulo the ring).
struct Arc
{
  std::uint16_t first = 0, count = 0;
};

constexpr unsigned int row_doubles = 8; ///< a row is one cache line: x, y, vx, vy, a, V, 1/gamma, unused
constexpr unsigned int block = 16;       ///< particles treated together in density()
constexpr unsigned int list_padding = 8; ///< lists are padded with the dummy row to this many entries

/// One cell, raw. Lengths: n fluid particles, n_wall nodes.
struct CellView
{
  std::uint32_t n = 0, n_wall = 0;
  const double *x[2]{}, *v[2]{};  ///< fluid positions (m) and velocities (m/s); v unused without viscosity
  double *f[2]{};                 ///< fluid forces (N), accumulated
  double *rho = nullptr;          ///< out, kg/m^3
  double *gamma = nullptr;        ///< out
  double *pressure = nullptr;     ///< out, Pa
  /// Wall nodes with the ring repeated: 2 n_wall + list_padding + 1 entries each.
  const double *wall_x[2]{}, *wall_v[2]{};
  double *wall_f[2]{};            ///< accumulated on face k's own node k; the caller folds the repeats back
  double *wall_f_next[2]{};       ///< accumulated on face k's other node k + 1
  const std::uint16_t *neighbours = nullptr; ///< local fluid indices, padded with n
  const std::uint32_t *first_neighbour = nullptr; ///< n + 1 offsets
  const Arc *arcs = nullptr;
  const std::uint32_t *first_arc = nullptr; ///< n + 1 offsets
  double *rows = nullptr;         ///< (n + 1) * row_doubles, 64-byte aligned scratch
  double *scratch = nullptr;      ///< 2 * scratch_half, 64-byte aligned
  std::uint32_t scratch_half = 0; ///< 4 list_padding * block * (chunks of faces one particle can see)
  double support = 0.;            ///< m
  double mass = 0.;               ///< kg, of one fluid particle
  double depth = 1.;              ///< m, slab depth: W is per area, rho per volume
  double viscosity = 0.;          ///< Pa s; 0 compiles the viscous part out
  void (*eos)(const void *, std::uint32_t n, const double *rho, double *p) = nullptr; ///< p(rho), Pa
  const void *eos_data = nullptr;
  std::uint32_t crossed = 0;      ///< out: particles found outside the wall
};

struct Sweeps
{
  /// rho, gamma, p of every particle and the pressure forces between fluid and wall.
  void (*density)(CellView &) = nullptr;
  /// The forces between fluid particles; needs density() at the same positions.
  void (*force)(CellView &) = nullptr;
  const char *name = "";
};

/// The fastest sweeps this processor can run; `TURGOR_SIMD=avx2` in the environment
/// forces the portable ones.
const Sweeps &sweeps();

const Sweeps &sweeps_avx2();
const Sweeps &sweeps_avx512();
} // namespace turgor::sph
