// Keeps fluid particles off the faces of a wall, from either side.
//
//   E = sum over particles and faces of V_0 P_b (1 - d/d_b)^2,  d: distance of particle and face (its edges
//   and corners
//   included), d < d_b;  V_0 = m/rho_0
//
// Why: gamma mirrors the fluid so well that a particle in uniform pressure feels nothing as it comes to the
// wall: the first layer of an annealed cell lies ON the wall (2D and 3D, measured). A closed cell pulls back
// what has come through; an open one does not (mirrored gamma), and without a barrier its fluid leaks
// everywhere. At the rim of a hole gamma turns from 1/2 to 1 around a line, with forces like 1/distance: the
// barrier keeps particles off that line too.
//
// In: lists, positions, V_0 P_b (J), d_b (m). Out: forces on both, energy (J). Momentum and angular momentum
// are kept.
#pragma once

#include "micro/terms/sph_lists.h"

namespace turgor {
constexpr double barrier_range = 0.3 / 2.6;  ///< d_b over the support: 0.3 spacings

double add_barrier(const WallArcs &arcs, Particles<2> &particles, const Group &group, double range,
                   double height);
double add_barrier(const WallFaces &faces, Particles<3> &particles, const Group &group,
                   const TriangleMesh &mesh, double range, double height);
}  // namespace turgor
