// A sphere of nearly equal triangles: the icosahedron, each side divided by nu, projected on the sphere and
// relaxed until its edges are as equal as the twelve fivefold nodes allow.
//
//   nodes 10 nu^2 + 2, faces 20 nu^2, edges 30 nu^2          (nu = 14: 1962 nodes)
//   relaxed: minimum of sum (l - mean l)^2 over the edges, nodes on the sphere
//
// In: nu (1 ... 80). Out: mesh, node positions on the unit sphere.
#pragma once

#include "micro/geometry/triangle_mesh.h"

namespace turgor {
struct GeodesicSphere {
  TriangleMesh mesh;
  std::vector<Vector<3>> positions;  ///< unit vectors
};

/// Throws std::invalid_argument for a nu out of range.
GeodesicSphere make_geodesic_sphere(unsigned int nu);
}  // namespace turgor
