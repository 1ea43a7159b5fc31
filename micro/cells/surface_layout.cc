#include "micro/cells/surface_layout.h"

#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
const TriangleMesh &belonging(const TriangleMesh &mesh, const std::vector<Vector<3>> &nodes) {
  if (nodes.size() != mesh.nodes)
    throw std::invalid_argument("The surface of a cell needs as many positions as its mesh has nodes.");
  return mesh;
}
}  // namespace

SurfaceLayout::SurfaceLayout(std::shared_ptr<const TriangleMesh> mesh_, std::vector<Vector<3>> nodes_,
                             const WallParameters &walls_, const FluidParameters &fluid_)
    : walls(walls_),
      fluid(fluid_),
      mesh(std::move(mesh_)),
      nodes(std::move(nodes_)),
      shape(belonging(*mesh, nodes), nodes) {
  for (const double area : shape.area_share)
    node_mass.push_back(walls.wall_density * walls.wall_thickness * area);
  if (!(volume() > 0.))
    throw std::invalid_argument("The surface of a cell encloses no volume: its faces have to be outward.");
  fluid_mass = fluid.fluid_density * volume();
}

double SurfaceLayout::volume() const {
  std::vector<double> x[3];
  for (int d = 0; d < 3; ++d)
    for (const Vector<3> &node : nodes) x[d].push_back(node[d]);
  return mesh->volume(x[0].data(), x[1].data(), x[2].data());
}

std::unique_ptr<NetWall> make_net_wall(const SurfaceLayout &layout) {
  const WallParameters &w = layout.walls;
  // Bending and mass both need the thickness; without bending the mass is still the wall's.
  return std::make_unique<NetWall>(
      layout.mesh, layout.shape,
      NetWallParameters{w.wall_stiffness, w.wall_thickness, w.wall_density, w.wall_bending});
}
}  // namespace turgor
