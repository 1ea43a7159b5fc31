// The wall of a 3D cell as triangles: who is joined to whom, without positions.
//
// Faces are counter-clockwise seen from outside. Every edge of a closed wall belongs to two faces: a and b
// are its ends, c the third node of the face in which a -> b runs, d that of the other; (a, b, c, d) is also
// its hinge.
#pragma once

#include "micro/geometry/tensor.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor {
struct TriangleMesh {
  struct Edge {
    std::uint16_t a, b, c, d;
    std::uint32_t left, right;  ///< faces: with c, with d
  };

  std::uint32_t nodes = 0;
  std::vector<std::array<std::uint16_t, 3>> faces;
  std::vector<Edge> edges;  ///< by complete(), in the order in which the faces name them
  std::vector<std::array<std::uint32_t, 3>> edges_of_face;

  /// Finds nodes, edges and hinges from the faces. Throws std::invalid_argument unless every edge belongs to
  /// exactly two faces, once in each direction.
  void complete();

  /// m^3 enclosed by nodes at x, y, z (m): sum of a . (b x c) / 6.
  double volume(const double *x, const double *y, const double *z) const;
  /// m^2.
  double area(const double *x, const double *y, const double *z) const;
};
}  // namespace turgor
