// Where the surfaces of deformable cells are asked what they touch: at their nodes, each with a quarter of
// its share of the area, and at the centroids of their triangles, with three quarters of theirs (a rule of
// second degree; nodes alone would let faces cross by a micrometre between them),
//
//   E = sum over points q of A_q e_q          A_q: m^2, of now; e_q: J/m^2, of what the point touches
//
// A force on a centroid is shared by the three nodes. As A_q is the area of now, e_q also is a tension of the
// triangles about it: each pulls at its nodes with -sigma da/dx, sigma = 3/4 e of its centroid + 1/12 of
// those of its nodes.
//
//   SurfacePoints points(surfaces);  points.update(particles, threads);
//   loads[q] = {force, e};  points.add_forces(particles, cell, loads);
//
// Points of a cell are one after another: its nodes, then its triangles.
#pragma once

#include "micro/terms/cell_surfaces.h"

#include <array>
#include <memory>
#include <span>

namespace turgor {
class SurfacePoints {
 public:
  explicit SurfacePoints(std::shared_ptr<const CellSurfaces> surfaces);

  /// Places and areas, where the particles are now.
  void update(const Particles<3> &particles, unsigned int threads);

  std::size_t size() const { return position.size(); }
  /// [begin, end) of a cell, after update().
  std::array<std::uint32_t, 2> of_cell(const std::size_t cell) const {
    return {first[cell], first[cell + 1]};
  }

  std::vector<Vector<3>> position;  ///< m
  std::vector<double> area;         ///< m^2, A_q
  std::vector<Vector<3>> normal;    ///< of each triangle, outwards

  /// Of a node of a cell: its number among the points, its place.
  std::uint32_t point_of(const std::size_t cell, const std::uint32_t node) const {
    return first[cell] + node - first_node[cell];
  }
  const Vector<3> &of_node(const std::size_t cell, const std::uint32_t node) const {
    return position[point_of(cell, node)];
  }

  struct Nodes {
    std::array<std::uint32_t, 3> node;
    std::uint32_t count;
    double share;
    std::span<const std::uint32_t> all() const { return {node.data(), count}; }
  };
  Nodes nodes_of(std::size_t cell, std::uint32_t point) const {
    const std::uint32_t k = point - first[cell], nodes = node_count[cell];
    if (k < nodes) return {{first_node[cell] + k, 0, 0}, 1, 1.};
    return {surfaces->triangles[surfaces->triangles_of(cell)[0] + k - nodes], 3, 1. / 3.};
  }

  struct Load {
    Vector<3> force = Vector<3>::Zero();  ///< N
    double energy = 0.;                   ///< J/m^2, e_q
  };
  /// f += what the loads on a cell's points do to its nodes. loads: of the points of_cell().
  void add_forces(Particles<3> &particles, std::size_t cell, std::span<const Load> loads) const;

 private:
  std::shared_ptr<const CellSurfaces> surfaces;
  std::vector<std::uint32_t> first{0}, first_node, node_count;
};
}  // namespace turgor
