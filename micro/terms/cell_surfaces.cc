#include "micro/terms/cell_surfaces.h"

#include "micro/geometry/closed_surface.h"
#include "micro/geometry/triangle_hinge.h"
#include "run/archive.h"

namespace turgor {
CellSurfaces::CellSurfaces() {
  for (const char *name : {"rest_length", "rest_angle", "flowed"}) edge_table.declare(name);
  triangle_table.declare("rest_area");
  for (const char *name : {"rest_volume", "rest_area"}) cells.declare(name);
}

void CellSurfaces::add(Particles<3> &particles, TriangleMesh mesh, const std::vector<Vector<3>> &nodes) {
  complete_closed_surface(mesh, nodes, "a cell");
  const std::uint32_t begin = std::uint32_t(particles.size()), end = begin + mesh.nodes;
  particles.resize(end);
  particles.groups.push_back({begin, end, end});
  for (std::uint32_t i = begin; i < end; ++i)
    for (int d = 0; d < 3; ++d) particles.x[d][i] = nodes[i - begin][d];
  for (const TriangleMesh::Edge &e : mesh.edges)
    edges.push_back({begin + e.a, begin + e.b, begin + e.c, begin + e.d});
  for (const auto &face : mesh.faces)
    triangles.push_back({begin + face[0], begin + face[1], begin + face[2]});
  const std::size_t cell = size();
  first_edge.push_back(std::uint32_t(edges.size()));
  first_triangle.push_back(std::uint32_t(triangles.size()));
  edge_table.resize(edges.size());
  triangle_table.resize(triangles.size());
  cells.resize(size());

  const auto at = [&](const std::uint32_t i) -> const Vector<3> & { return nodes[i - begin]; };
  for (std::uint32_t k = first_edge[cell]; k < first_edge[cell + 1]; ++k) {
    const auto &[a, b, c, d] = edges[k];
    const TriangleHinge hinge(at(a), at(b), at(c), at(d));
    edge_table.column("rest_length")[k] = hinge.length;
    edge_table.column("rest_angle")[k] = hinge.angle;
  }
  for (std::uint32_t k = first_triangle[cell]; k < first_triangle[cell + 1]; ++k) {
    const auto &[a, b, c] = triangles[k];
    triangle_table.column("rest_area")[k] = 0.5 * twice_area(at(a), at(b), at(c)).norm();
  }
  cells.column("rest_volume")[cell] = volume(particles, cell);
  cells.column("rest_area")[cell] = area(particles, cell);
}

double CellSurfaces::volume(const Particles<3> &particles, const std::size_t cell) const {
  // about its first node: about a far origin little would be left of the digits
  const Vector<3> centre = particles.position(particles.groups[cell].begin);
  double six = 0.;
  for (std::uint32_t k = first_triangle[cell]; k < first_triangle[cell + 1]; ++k) {
    const auto &[i, j, l] = triangles[k];
    const Vector<3> a = particles.position(i);
    six += (a - centre).dot(twice_area(a, particles.position(j), particles.position(l)));
  }
  return six / 6.;
}

double CellSurfaces::area(const Particles<3> &particles, const std::size_t cell) const {
  double twice = 0.;
  for (std::uint32_t k = first_triangle[cell]; k < first_triangle[cell + 1]; ++k) {
    const auto &[i, j, l] = triangles[k];
    twice += twice_area(particles.position(i), particles.position(j), particles.position(l)).norm();
  }
  return 0.5 * twice;
}

void CellSurfaces::add_volume_gradient(const Particles<3> &particles, const std::size_t cell,
                                       std::vector<Vector<3>> &gradient) const {
  const std::uint32_t begin = particles.groups[cell].begin;
  for (std::uint32_t k = first_triangle[cell]; k < first_triangle[cell + 1]; ++k) {
    const auto &[i, j, l] = triangles[k];
    const Vector<3> third =
        twice_area(particles.position(i), particles.position(j), particles.position(l)) / 6.;
    for (const std::uint32_t node : triangles[k]) gradient[node - begin] += third;
  }
}

void CellSurfaces::archive(Archive &a) {
  a.section("cell_surfaces");
  a(edge_table, triangle_table, cells);
}
}  // namespace turgor
