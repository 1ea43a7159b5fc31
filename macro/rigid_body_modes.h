// The motions of a mesh that cost no energy at rest, by entry [node][dim], one mode after the other: dim
// translations, then 1 (2D) or 3 (3D) rotations about the middle of the nodes, in units of their largest
// distance from it. Zero at clamped nodes.
#pragma once

#include "macro/tissue_mesh.h"

#include <vector>

namespace turgor {
template <int dim>
std::vector<double> rigid_body_modes(const TissueMesh<dim> &mesh, bool with_rotations = true);
}
