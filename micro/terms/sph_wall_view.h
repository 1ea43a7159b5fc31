// Brings a cell's wall into the form that the sweeps read, and the wall's forces back: a ring of edges (2D,
// sph_wall_ring.cc) or triangles (3D, sph_wall_mesh.cc); the volume inside the wall and its derivatives.
//
//   2D: V = depth A, dA/dx_k = half the next node's y minus the previous one's, and so on
//   3D: V = sum a . (b x c) / 6 over the faces, dV/da = sum b x c / 6 over the faces of the node a
#pragma once

#include "micro/terms/sph_lists.h"

#include <cstddef>

namespace turgor {
struct WallSettings {
  double depth = 1.;                   ///< m, 2D
  bool viscous = false;                ///< for the viscous sweep: velocities, and in 3D room for its rays
  const TriangleMesh *mesh = nullptr;  ///< 3D
};

/// How the nodes of a wall act on the bulk of the fluid inside.
struct WallBulk {
  double volume = 0.;          ///< m^3
  double slopes_squared = 0.;  ///< sum over the nodes of |d volume / d node|^2, or a bound of it, m^4
  double node_area = 0.;       ///< m^2 of wall for one node
};

template <int dim>
class WallView {
 public:
  using Lists = std::conditional_t<dim == 2, WallArcs, WallFaces>;

  WallView(const Lists &lists, const Group &group, const WallSettings &settings);
  std::size_t doubles() const;  ///< of scratch needed, a multiple of 8
  /// Points the view to memory (64-byte aligned), with positions, velocities and lists filled in.
  void attach(sph::CellView<dim> &view, const Particles<dim> &particles, double *memory);
  double volume() const { return enclosed; }  ///< m^3; after attach
  /// Adds the wall's forces (N) to f of the wall's nodes.
  void add_forces(const sph::CellView<dim> &view, double *const (&f)[dim]) const;
  /// Adds the wall's forces, and pressure (Pa) times d volume / d node, to the wall's nodes.
  void collect(const sph::CellView<dim> &view, double pressure, Particles<dim> &particles) const;

  static WallBulk bulk(const Particles<dim> &particles, const Group &group, const WallSettings &settings);

 private:
  const Lists &lists;
  const Group group;
  const WallSettings settings;
  double enclosed = 0.;
  const double *slopes = nullptr;  ///< 3D: 6 dV/dx, 4 doubles a node
};
}  // namespace turgor
