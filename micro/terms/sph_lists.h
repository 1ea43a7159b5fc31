// Who is near whom in one cell of the SPH fluid: for every fluid particle the fluid particles of the same
// cell and the faces of the wall within reach, in the form the sweeps read (arcs of a ring in 2D; in 3D for
// every triangle the particles).
//
// A triangle's quadrature is chosen here, by its distance over its size, and kept until the next build: sums
// switch quadrature only then. Faces that are gone (an opened wall) are left out.
#pragma once

#include "micro/geometry/triangle_mesh.h"
#include "micro/terms/list_origin.h"
#include "micro/terms/sph_sweeps.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace turgor {
/// The wall's part in 2D.
struct WallArcs {
  std::vector<std::uint32_t> first_arc;  ///< offsets, one more than fluid particles
  std::vector<sph::Arc> arcs;
  std::uint32_t chunks = 0;  ///< of list_padding faces, over all particles

  /// Particles i = wall_count ... of origin; gone: one a face, or nothing. reach in m.
  void build(const ListOrigin<2> &origin, std::uint32_t wall_count, double reach,
             const std::vector<unsigned char> *gone);
  void clear(std::uint32_t particles);
  std::size_t memory_bytes() const { return first_arc.capacity() * 4 + arcs.capacity() * sizeof(sph::Arc); }
};

/// The wall's part in 3D.
struct WallFaces {
  std::vector<sph::FaceList> faces;  ///< those in reach of a particle
  std::vector<std::uint16_t> particles;
  std::size_t kept = 0;  ///< doubles for CellView<3>::kept

  std::vector<sph::Rim> rims;
  std::vector<std::uint16_t> rim_nodes;
  std::vector<double> toward;
  std::vector<sph::Doubt> doubts;
  std::uint32_t longest = 0;  ///< rim

  /// slack: how far a particle can come nearer to a face before the next build; near: faces that can come
  /// nearer than this are in quadrature 0, m.
  void build(const ListOrigin<3> &origin, std::uint32_t wall_count, const TriangleMesh &mesh, double reach,
             double slack, double near, const std::vector<unsigned char> *gone);
  void clear(std::uint32_t particles);
  std::size_t memory_bytes() const;

 private:
  struct Side {
    std::uint16_t from, to;
  };
  std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>> near_faces(std::uint32_t n) const;
  /// Of particle i; uses the sides up.
  void close_rims(std::uint32_t i, std::vector<Side> &sides);
  /// found: particles by quadrature, those that count first; far: the others. Uses both up.
  void add_list(std::uint32_t face, std::vector<std::uint16_t> *found, const std::vector<std::uint16_t> *far);
  /// middle, size: of the faces, m.
  void build_rims(const ListOrigin<3> &origin, std::uint32_t wall_count, const TriangleMesh &mesh,
                  const std::vector<Vector<3>> &middle, const std::vector<double> &size, double slack);
};

/// Fluid particles of one cell: neighbours of each.
struct FluidNeighbours {
  std::vector<std::uint16_t> neighbours;       ///< fluid indices, padded with the number of fluid particles
  std::vector<std::uint32_t> first_neighbour;  ///< offsets, one more than fluid particles

  /// Particles i = wall_count ... of origin; reach in m. The last `ghosts` of them are images that are
  /// neighbours and have none.
  template <int dim>
  void build(const ListOrigin<dim> &origin, std::uint32_t wall_count, double reach, std::uint32_t ghosts = 0);
  void clear(std::uint32_t particles);
  std::size_t memory_bytes() const { return neighbours.capacity() * 2 + first_neighbour.capacity() * 4; }
};

template <int dim>
struct SphLists {
  FluidNeighbours fluid;
  std::conditional_t<dim == 2, WallArcs, WallFaces> wall;

  std::size_t memory_bytes() const { return fluid.memory_bytes() + wall.memory_bytes(); }
};
}  // namespace turgor
