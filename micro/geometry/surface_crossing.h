// Whether a closed surface of triangles goes through itself.
//
// Two triangles cross where an edge of one passes through the inside of the other; those that have a node in
// common are asked for the edges that do not touch it. A surface that is folded back on itself at an edge
// (angle between the faces below 1e-6) crosses, too. Triangles that touch, or lie in one plane on one
// another, are not found. Pairs: by their boxes, sorted along x: about n^(3/2) for n triangles of a round
// body.
#pragma once

#include "micro/geometry/triangle_mesh.h"

#include <optional>
#include <utility>

namespace turgor {
/// Two triangles that cross; nodes: m; mesh: complete().
std::optional<std::pair<std::uint32_t, std::uint32_t>> find_crossing(const TriangleMesh &mesh,
                                                                     const std::vector<Vector<3>> &nodes);
}  // namespace turgor
