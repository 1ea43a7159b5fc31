// How round a closed surface of triangles is meant to be at its nodes: the mean curvature H (1/m) that its
// edges carry there.
//
//   H = sum_e l_e theta_e/4 / A      edges e at the node: length l, angle theta between the normals of the
//   two
//                                    faces, convex positive (Steiner: the integral of H over an edge is l
//                                    theta/2, half of it for each end)
//   A = sum of the faces' shares     by the circumcentre, in obtuse triangles half and quarters (M. Meyer et
//                                    al. 2003, 10.1007/978-3-662-05105-4_2)
//
// On a sphere H = 1/R to second order in the width of the triangles, however unlike they are; on a cylinder
// 1/(2 R). An edge sharper than `crease` is meant sharp: a node at one has H = 0. Angles below 1e-6 are none:
// a flat side stays flat to the last bit.
#pragma once

#include "micro/geometry/triangle_mesh.h"

#include <numbers>

namespace turgor {
constexpr double sharp_crease = std::numbers::pi / 6.;  ///< rad

/// 1/m, of each node. mesh: complete(); nodes: m; crease: rad.
std::vector<double> facet_curvature(const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes,
                                    double crease = sharp_crease);
}  // namespace turgor
