// The two hot sweeps of the fluid in one cell, 2D and 3D, over plain arrays, compiled once
// per instruction set and chosen at run time (sph_sweeps_portable.cc, sph_sweeps_avx2.cc,
// sph_sweeps_avx512.cc).
//
// Formulation: variational, wall-corrected summation density with the cell's exact volume. For fluid particle
// i
//   gamma_i = integral over the cell of W(|x - x_i|)       (share of the kernel inside the wall)
//   r_i     = (m / gamma_i) sum_j W_ij                     (self included)
//   rho_i   = s r_i,  s = sum_j (m / r_j) / V              V: the exact volume inside the wall
//   E       = sum_i m e(rho_i) + p_0 V (1 - s)
//   f_k     = -dE/dx_k = (p_mean - p_0) dV/dx_k - sum_i (m s / rho_i^2) (p_i - p_mean + s p_0) dr_i/dx_k
//             p_mean = sum_i (m / rho_i) p_i / V            for fluid and wall alike
// With a WallLayer (sph_wall_layer.h) a particle's own image behind the wall is added: r_i = (m/gamma_i)
// (sum_j W_ij + W(0) X(gamma_i)). s makes the particles' volumes fill the cell exactly: how the particles
// happen to be packed (0.05 % of density are 10 % of turgor) no longer decides the pressure, which acts on
// the wall's own polygon or polyhedron, while the sums carry what differs from it. Nothing would then keep
// the particles evenly spread (any packing with equal r_i is at rest), so disorder, 1 - s, costs a little
// energy: p_0, the ordering pressure. Without a volume (an open wall) s is a given number, p_mean = p_0 = 0.
// gamma from the wall alone, with G: div(r G) = W, D = G - 1/(Omega r^d), Omega = 2 pi or 4 pi:
//   gamma_i = 1 + sum_faces [ integral G r.n dS - angle / Omega ] = 1 + sum_faces integral D r.n dS,
// by Gauss on the face: on the first form near the particle, the angle exact; on the second, which has no
// angle and fades to 0 at the support, on 3D's faces far away. The discrete expression itself is
// differentiated, so F = -dE/dx and momentum hold to round-off (compare Ferrand et al. 2013,
// 10.1002/fld.3666, for the continuous correction).
//
// Open cell (some faces gone, `open`): the sum runs over the faces that are left. It still is 1 out of reach
// of any face, and runs continuously through the hole: below 1 inside, above 1 outside (to 3/2 at the outer
// side of a flat wall; across the wall itself it jumps by 1). gamma = 1 - |sum - 1| mirrors it, so that a
// particle outside feels the wall from there as one inside does: 1/2 on either side, 1 far off (and again
// where a crumpled wall laps over itself and the sum runs from 1.5 to 2). Below 1/2, in the folds of a torn
// wall, where the kernel's own peak over gamma would make a lone particle denser than liquid, gamma runs out
// smoothly to 0.4: 0.4 + 0.1 exp((gamma - 1/2)/0.1). It has a crease in the plane of the hole, where the
// force, not the energy, jumps. The pressure of an open cell is max(0, p), energy 0 below rho_0: a free
// surface lacks neighbours, and tension would pull it together. s stays what it was when the wall broke, or
// the pressure would jump by 7 K (1 - s) in that moment.
//
// Kernel: Wendland C2 (no pairing instability), W = C (1 - u)^4 (4 u + 1), u = r / support; or (fourth_order)
// W times a polynomial that takes its second moment away, so that sound of wave number k runs at c (1 -
// O(k^4)), not c (1 - O(k^2)): sph_kernels.inc.h. Viscosity: a velocity gradient per particle by least
// squares, exact for affine flow and objective (sph_viscosity.inc.h).
#pragma once

#include <cstdint>
#include <vector>

namespace turgor::sph {
constexpr unsigned int row_doubles = 4;  ///< two rows are one cache line
template <int dim>
constexpr unsigned int viscous_row =
    dim == 2 ? 8 : 16;                    ///< doubles of a particle's row in sph_viscosity.inc.h
constexpr unsigned int list_padding = 8;  ///< lists are padded with the dummy row to this many entries

/// Columns of a particle's row: 2D: x y a -;  3D: x y z a.   a = V (p_i - p_mean + s p_0) s / (rho gamma)
template <int dim>
struct Column {
  static constexpr int a = dim;
};

/// One cell, raw: what 2D and 3D share. n fluid particles, n_wall nodes.
template <int dim>
struct CellBase {
  std::uint32_t n = 0, n_wall = 0;
  const double *x[dim]{}, *v[dim]{};  ///< fluid positions (m) and velocities (m/s); v: of viscosity() alone
  double *f[dim]{};                   ///< fluid forces (N), accumulated
  // A periodic fluid (not viscosity()): images of particles stand behind the n in x and in the lists.
  std::uint32_t ghosts = 0;
  const std::uint32_t *ghost_of = nullptr;  ///< whose image each is
  double *rho = nullptr;                    ///< out, kg/m^3
  double *gamma = nullptr;                  ///< out
  double *pressure = nullptr;               ///< out, Pa
  double *push = nullptr;  ///< n scratch: V (p_i - p_mean + s p_0) / gamma, signed as d gamma is, J
  const std::uint16_t *neighbours = nullptr;       ///< local fluid indices, padded with n + ghosts
  const std::uint32_t *first_neighbour = nullptr;  ///< n + 1 offsets
  double *rows = nullptr;          ///< (n + ghosts + 1) * row_doubles, 64-byte aligned scratch
  double support = 0.;             ///< m
  double mass = 0.;                ///< kg, of one fluid particle
  double depth = 1.;               ///< m, slab depth: in 2D W is per area, rho per volume; 1 in 3D
  double viscosity = 0.;           ///< Pa s; of viscosity() alone, as the next three
  double particle_volume = 0.;     ///< m^3, the same for all
  double *viscous_rows = nullptr;  ///< (n + 1) * viscous_row<dim>, 64-byte aligned scratch
  double *moments = nullptr;       ///< n * viscous_row<dim>, 64-byte aligned scratch
  void (*eos)(const void *, std::uint32_t n, const double *rho, double *p) = nullptr;  ///< p(rho), Pa
  const void *eos_data = nullptr;
  double volume = 0.;    ///< m^3, inside the wall; 0, with ordering 0: s is given
  double ordering = 0.;  ///< Pa, p_0
  bool open = false;     ///< faces are missing
  double layer_linear = 0.,
         layer_square = 0.;   ///< a particle's image behind the wall (sph_wall_layer.h); square 0: none
  bool fourth_order = false;  ///< the kernel of the sums and gamma; closed cells only
  double scale = 1.;          ///< out, s; in, where volume is 0
  double mean_pressure = 0.;  ///< out, Pa, p_mean; the caller applies (p_mean - p_0) dV/dx to the wall
  std::uint32_t crossed = 0;  ///< out: particles found outside a closed wall
};

/// Consecutive wall faces [first, first + count) within reach of a particle; face k joins
/// ring nodes k and k + 1 (modulo the ring).
struct Arc {
  std::uint16_t first = 0, count = 0;
};

/// 3D: the fluid particles that a face is in reach of, in the order of the quadratures they need of it
/// (nearest first), each quadrature padded to list_padding with its last particle.
constexpr int quadratures = 3;  ///< 6 points on G, where the angle is exact; 3, 1 points on D
constexpr int quadrature_points[quadratures] = {6, 3, 1};
struct FaceList {
  std::uint32_t face = 0, first = 0;  ///< first: offset into face_particles
  std::uint16_t count[quadratures]{};
};

/// 3D: a closed way along wall nodes [first, first + count) of rim_nodes around the faces of quadrature 0
/// that a particle sees, counter-clockwise seen from outside; the angle of all these faces is that of their
/// rims.
struct Rim {
  std::uint32_t particle = 0, first = 0;  ///< first: a multiple of list_padding
  std::uint32_t count = 0;
};

/// 3D: a face of quadrature 0 that a particle may have behind it, seen along its `toward`.
struct Doubt {
  std::uint32_t particle = 0, face = 0;
};

/// 2D: two points of a face that a particle sees, each as its place from the face's own node (0) to the next
/// (1) and its weight over mu V (sph_viscous_edges.inc.h).
constexpr unsigned int ray_doubles = 4;

template <int dim>
struct CellView;

template <>
struct CellView<2> : CellBase<2> {
  /// Wall nodes with the ring repeated: 2 n_wall + list_padding + 1 entries each.
  const double *wall_x[2]{}, *wall_v[2]{};
  double *wall_f[2]{};       ///< accumulated on face k's own node k; the caller folds the repeats back
  double *wall_f_next[2]{};  ///< accumulated on face k's other node k + 1
  const Arc *arcs = nullptr;
  const std::uint32_t *first_arc = nullptr;  ///< n + 1 offsets
  double *scratch =
      nullptr;  ///< 4 list_padding * (chunks of list_padding faces that all particles see), 64-byte aligned
  double *arc_ends = nullptr;    ///< 5 * arc_stride scratch
  std::uint32_t arc_stride = 0;  ///< number of arcs, rounded up to list_padding
  double *ray_points = nullptr;  ///< out, of rays() alone: ray_doubles for each face of the arcs in order
};

template <>
struct CellView<3> : CellBase<3> {
  // Wall nodes, 4 doubles each (the last 0 or unused), 64-byte aligned.
  const double *wall_x = nullptr, *wall_v = nullptr;  ///< m, m/s; wall_v: of viscosity() alone
  double *wall_f = nullptr;                           ///< N, accumulated
  const std::uint16_t *corners = nullptr;             ///< wall nodes, 3 a face
  const FaceList *face_lists = nullptr;               ///< of the faces in reach of any particle
  std::uint32_t n_faces = 0;                          ///< of these
  const std::uint16_t *face_particles = nullptr;
  const Rim *rims = nullptr;  ///< in the order of the particles
  std::uint32_t n_rims = 0;
  const std::uint16_t *rim_nodes = nullptr;
  const double *toward = nullptr;  ///< 3 n, unit vectors to a near face
  const Doubt *doubts = nullptr;
  std::uint32_t n_doubts = 0;
  // Scratch, 64-byte aligned.
  double *own = nullptr, *pull = nullptr;  ///< 4 (n + 1) each
  double *rim_pull = nullptr;              ///< 4 for every rim node: 8 pi support * d gamma / d node
  double *rim_scratch = nullptr;           ///< 8 (longest rim + 2 list_padding)
  double *kept_rays = nullptr;             ///< of viscosity(): 6 for every particle of face_particles
  double *kept = nullptr;           ///< for every particle of face_particles 1 + points of its quadrature
  std::uint16_t *active = nullptr;  ///< quadratures for every face: chunks within the support
};

template <int dim>
struct Sweeps {
  /// rho, gamma, p of every particle and the forces of p - p_mean + s p_0 between fluid and wall.
  void (*density)(CellView<dim> &) = nullptr;
  /// The forces between fluid particles; needs density() at the same positions.
  void (*force)(CellView<dim> &) = nullptr;
  /// Adds Newton's viscosity by the particles' velocity gradients (sph_viscosity.inc.h), of fluid and wall.
  /// After the others: it overwrites the wall's scratch.
  void (*viscosity)(CellView<dim> &) = nullptr;
  /// 2D: the points of the wall by which viscosity() sees it, for those who multiply by themselves.
  void (*rays)(CellView<dim> &) = nullptr;
  const char *name = "";  ///< its word in TURGOR_SIMD
};

/// The sweeps that are in this program and that this processor can run, the fastest last; the first are the
/// portable ones.
template <int dim>
const std::vector<const Sweeps<dim> *> &known_sweeps();

/// The fastest of them, or those that TURGOR_SIMD in the environment names: `portable`, `avx2`, `avx512`.
/// Throws std::invalid_argument for any other word.
template <int dim>
const Sweeps<dim> &sweeps();

template <int dim>
const Sweeps<dim> &sweeps_portable();
template <int dim>
const Sweeps<dim> &sweeps_avx2();
template <int dim>
const Sweeps<dim> &sweeps_avx512();
}  // namespace turgor::sph
