// Whether the closed surfaces of one mesh bound bodies: side by side, or a hollow that faces inwards inside a
// body that faces outwards. Of each part one node is asked how often the others wind around it, by their
// solid angles there (van Oosterom, Strackee 1983, doi:10.1109/TBME.1983.325207): 0 times around a body, once
// around a hollow. For parts that do not cross (surface_crossing.h).
#pragma once

#include "micro/geometry/triangle_mesh.h"

#include <optional>

namespace turgor {
struct WrongNesting {
  std::size_t parts;       ///< closed surfaces in all
  std::uint32_t triangle;  ///< the first of the part that is wrong
  bool outwards;           ///< that part faces outwards
};

/// nodes: m; mesh: complete().
std::optional<WrongNesting> find_wrong_nesting(const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes);
}  // namespace turgor
