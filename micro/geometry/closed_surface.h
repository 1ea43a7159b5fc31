// Whether triangles and nodes are the closed surface of one body: what cells and bodies that are given as
// triangles are asked before anything is made of them.
//
//   complete_closed_surface(mesh, nodes, "a cell");       // mesh.edges and mesh.nodes are there afterwards
//
// Asked: every edge has two triangles, once in each direction; every node is named, and its triangles are one
// fan; no triangle without area (1e-12 of its longest edge squared); counter-clockwise seen from outside. Not
// asked: whether the surface crosses itself, whether it is in one piece.
#pragma once

#include "micro/geometry/triangle_mesh.h"

#include <string>

namespace turgor {
/// nodes: m. Throws std::invalid_argument with a sentence about `what`.
void complete_closed_surface(TriangleMesh &mesh, const std::vector<Vector<3>> &nodes,
                             const std::string &what);
}  // namespace turgor
