// The two hot sweeps of the fluid in one closed cell, over plain arrays, compiled once
// per instruction set and chosen at run time (sph_sweeps_avx2.cc, sph_sweeps_avx512.cc).
//
// Formulation: variational, wall-corrected summation density with the cell's exact volume. For fluid particle i
//   gamma_i = integral over the cell of W(|x - x_i|)       (share of the kernel inside the wall)
//   r_i     = (m / gamma_i) sum_j W_ij                     (self included)
//   rho_i   = s r_i,  s = sum_j (m / r_j) / V              V: the exact volume inside the wall
//   E       = sum_i m e(rho_i) + p_0 V (1 - s)
//   f_k     = -dE/dx_k = (p_mean - p_0) dV/dx_k - sum_i (m s / rho_i^2) (p_i - p_mean + s p_0) dr_i/dx_k
//             p_mean = sum_i (m / rho_i) p_i / V            for fluid and wall alike
// s makes the particles' volumes fill the cell exactly: how the particles happen to be packed (0.05 % of density
// are 10 % of turgor) no longer decides the pressure, which acts on the wall's own polygon, while the sums
// carry what differs from it. Nothing would then keep the particles evenly spread (any packing
// with equal r_i is at rest), so disorder, 1 - s, costs a little energy: p_0, the ordering pressure.
// Without a volume (an open wall) s = 1, p_mean = p_0 = 0.
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

constexpr unsigned int row_doubles = 8; ///< a row is one cache line: x, y, vx, vy, a, V, 1/gamma, b
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
  std::uint32_t scratch_half = 0; ///< 4 list_padding * (chunks of list_padding faces that all particles see)
  double *arc_ends = nullptr;     ///< 5 * arc_stride scratch
  std::uint32_t arc_stride = 0;   ///< number of arcs, rounded up to list_padding
  double support = 0.;            ///< m
  double mass = 0.;               ///< kg, of one fluid particle
  double depth = 1.;              ///< m, slab depth: W is per area, rho per volume
  double viscosity = 0.;          ///< Pa s; 0 compiles the viscous part out
  void (*eos)(const void *, std::uint32_t n, const double *rho, double *p) = nullptr; ///< p(rho), Pa
  const void *eos_data = nullptr;
  double volume = 0.;             ///< m^3, inside the wall; 0, with ordering 0: densities are left as summed
  double ordering = 0.;           ///< Pa, p_0
  double scale = 1.;              ///< out, s
  double mean_pressure = 0.;      ///< out, Pa, p_mean; the caller applies (p_mean - p_0) dV/dx to the wall
  std::uint32_t crossed = 0;      ///< out: particles found outside the wall
};

struct Sweeps
{
  /// rho, gamma, p of every particle and the forces of p - p_mean + s p_0 between fluid and wall.
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
