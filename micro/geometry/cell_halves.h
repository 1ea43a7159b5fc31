// A closed surface of triangles cut into two halves of one volume by a plane, and a surface put into each
// half: where the daughters of a deformable cell lie (thesis B.2, Fig. 2.6).
//
//   plane     normal to a direction, where both halves have the same volume (bisection)
//   centre    of mass of each half
//   daughter  a sphere's nodes, sent out from the centre of a half along their directions until they meet the
//             surface or the plane moved back by half a gap. Then they slide on both (the cocoon): over some
//             sweeps each is drawn along its edges towards where these are equally long, and sent out anew
//
// What is sent out from one point along different directions crosses itself nowhere, and nothing lies beyond
// the first thing met: daughters are inside their halves, whatever shape these have. Of a half that its
// centre does not see all of they have less volume.
//
//   const CellHalves halves(nodes, faces, along);
//   for (int side : {0, 1}) nodes = halves.daughter(side, mesh, directions, gap, sweeps);
#pragma once

#include "micro/geometry/triangle_mesh.h"

#include <array>

namespace turgor {
class CellHalves {
 public:
  using Faces = std::vector<std::array<std::uint32_t, 3>>;

  /// nodes: m; faces: counter-clockwise seen from outside, both stay where they are; along: unit vector,
  /// towards half 0.
  CellHalves(const std::vector<Vector<3>> &nodes, const Faces &faces, const Vector<3> &along);

  double volume(const int side) const { return half[std::size_t(side)].volume; }            ///< m^3
  const Vector<3> &centre(const int side) const { return half[std::size_t(side)].centre; }  ///< m

  /// m, of the nodes of a mesh whose directions (unit vectors) are given; gap: m, between both daughters.
  /// Throws std::runtime_error where the centre of the half is outside of the surface.
  std::vector<Vector<3>> daughter(int side, const TriangleMesh &mesh, std::vector<Vector<3>> directions,
                                  double gap, unsigned int sweeps) const;

 private:
  struct Half {
    double volume = 0.;
    Vector<3> centre = Vector<3>::Zero();
  };
  /// What lies beyond height (m) along a direction from the origin.
  Half beyond(const Vector<3> &direction, double height) const;

  const std::vector<Vector<3>> &nodes;
  const Faces &faces;
  Vector<3> along;
  double height = 0.;  ///< m, of the plane
  std::array<Half, 2> half;
};
}  // namespace turgor
