// The surfaces of deformable cells (thesis 2.3.2): each cell is a group of nodes on a closed triangulated
// surface. Who is joined to whom, and what each edge, triangle and cell is at rest; its terms
// (cortex_edges.h, cortex_hinges.h, cortex_area.h, cytoplasm.h) share it; to groups behind its cells they do
// nothing.
//
//   const auto surfaces = std::make_shared<CellSurfaces>();
//   surfaces->add(particles, mesh, nodes);
//     // one more group, free of stress as it lies there
//   system.add(std::make_unique<Cytoplasm>(surfaces, 2500.));
//
// Columns of the tables: edges rest_length (m), rest_angle (rad), flowed (m: how much longer a spring without
// tension is by its flow); triangles rest_area (m^2); cells rest_volume (m^3), rest_area (m^2).
#pragma once

#include "micro/engine/particles.h"
#include "micro/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor {
class CellSurfaces {
 public:
  struct Edge  ///< particles: a and b its ends, c the third node of the triangle in which it runs a -> b, d
               ///< that of the other
  {
    std::uint32_t a, b, c, d;
  };
  using Triangle = std::array<std::uint32_t, 3>;  ///< particles, counter-clockwise seen from outside

  CellSurfaces();

  /// One more cell: a group behind all particles. nodes: m. Throws std::invalid_argument where they are no
  /// closed surface (closed_surface.h).
  void add(Particles<3> &particles, TriangleMesh mesh, const std::vector<Vector<3>> &nodes);

  /// One more cell: a group behind all particles, joined and at rest as a cell of others is. nodes: m, as
  /// many as that has.
  void add(Particles<3> &particles, const CellSurfaces &others, std::size_t other,
           const std::vector<Vector<3>> &nodes);
  /// A cell is at rest as a cell of others is, which has as many edges and triangles.
  void take_rest(std::size_t cell, const CellSurfaces &others, std::size_t other);
  /// Growth by the reference state (thesis B.17, B.2): at rest a cell has another volume (m^3) and the same
  /// shape, so that lengths grow with its cube root and areas with the square of that.
  void grow(std::size_t cell, double volume);

  std::size_t size() const { return first_edge.size() - 1; }  ///< cells
  /// Of a cell: [begin, end) of its edges, of its triangles.
  std::array<std::uint32_t, 2> edges_of(const std::size_t cell) const {
    return {first_edge[cell], first_edge[cell + 1]};
  }
  std::array<std::uint32_t, 2> triangles_of(const std::size_t cell) const {
    return {first_triangle[cell], first_triangle[cell + 1]};
  }

  double volume(const Particles<3> &particles, std::size_t cell) const;  ///< m^3
  double area(const Particles<3> &particles, std::size_t cell) const;    ///< m^2
  /// gradient += dV/dx (m^2) of every node of the cell: where it is, a third of its triangles' areas times
  /// their normals.
  void add_volume_gradient(const Particles<3> &particles, std::size_t cell,
                           std::vector<Vector<3>> &gradient) const;

  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
  Table edge_table, triangle_table, cells;

  void archive(Archive &a);  ///< the tables; who is joined to whom follows from the input
  /// Who is joined to whom, and the particles' groups: of cells whose number changes, before all else of
  /// them.
  void archive_joints(Archive &a, Particles<3> &particles);

 private:
  void append(Particles<3> &particles, const std::vector<Vector<3>> &nodes);  ///< the nodes of one more cell

  std::vector<std::uint32_t> first_edge{0}, first_triangle{0};
};

/// (m) twice the area of a triangle times its normal.
inline Vector<3> twice_area(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c) {
  const Vector<3> u = b - a, v = c - a;
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

inline void add_force(Particles<3> &particles, const std::uint32_t i, const Vector<3> &force) {
  for (int d = 0; d < 3; ++d) particles.f[d][i] += force[d];
}
}  // namespace turgor
