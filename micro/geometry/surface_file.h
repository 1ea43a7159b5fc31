// A closed surface of triangles from a file: rigid bodies (triangulated_body.h), deformable cells.
//
//   SurfaceOfTriangles body = read_surface("pillar.stl", 1e-6);                     written in micrometres
//   TriangulatedBody(body.mesh, body.nodes, ParticlesAre::outside)
//
// By the file's ending: .stl (binary or ASCII; corners in the very same place are one node), .off, .obj
// (lines v and f; others mean nothing here). Faces are triangles. What is read has been asked whether it is
// the surface of a body: closed, counter-clockwise seen from outside, no triangle without area
// (closed_surface.h), none through another one (surface_crossing.h).
//
// In: file, metres to a unit of the file. Out: triangles, nodes (m). At most 65535 nodes.
#pragma once

#include "micro/geometry/triangle_mesh.h"

#include <filesystem>

namespace turgor {
struct SurfaceOfTriangles {
  TriangleMesh mesh;
  std::vector<Vector<3>> nodes;  ///< m
};

/// Throws InputError with a sentence that names the file, and the line where there is one.
SurfaceOfTriangles read_surface(const std::filesystem::path &file, double unit = 1.);
}  // namespace turgor
