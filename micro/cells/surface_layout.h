// What is where in a 3D cell whose wall is a closed surface of triangles, and at what lengths and angles the
// wall is free of stress: what CellLayout (cell_layout.h) says of rings.
//
//   edge k     rest length, dual width and rest angle of NetShape (net_wall.h)
//   node i     its mass, that of its share of the wall's area
//
//   SurfaceLayout layout(mesh, nodes, walls);
//   system.add(make_net_wall(layout));
//
// In and out: m, kg, rad.
#pragma once

#include "micro/cells/fluid_parameters.h"
#include "micro/cells/wall_parameters.h"
#include "micro/terms/net_wall.h"

#include <memory>
#include <vector>

namespace turgor {
struct SurfaceLayout {
  WallParameters walls;
  FluidParameters fluid;
  std::shared_ptr<const TriangleMesh> mesh;  ///< outward faces
  std::vector<Vector<3>> nodes;              ///< m, where the wall is free of stress
  NetShape shape;                            ///< rest lengths, widths, angles
  std::vector<double> node_mass;             ///< kg
  double fluid_mass = 0.;                    ///< kg

  /// The wall is free of stress in the shape it has there; the fluid has its density without pressure and
  /// fills it. Throws std::invalid_argument where mesh and nodes do not belong together or the surface
  /// encloses nothing.
  SurfaceLayout(std::shared_ptr<const TriangleMesh> mesh, std::vector<Vector<3>> nodes,
                const WallParameters &walls, const FluidParameters &fluid);

  double volume() const;  ///< m^3
};

/// The wall of the layout.
std::unique_ptr<NetWall> make_net_wall(const SurfaceLayout &layout);
}  // namespace turgor
