#include "micro/terms/cell_surfaces.h"

#include "micro/geometry/closed_surface.h"
#include "micro/geometry/triangle_hinge.h"
#include "run/archive.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
CellSurfaces::CellSurfaces() {
  for (const char *name : {"rest_length", "rest_angle", "flowed"}) edge_table.declare(name);
  triangle_table.declare("rest_area");
  for (const char *name : {"rest_volume", "rest_area"}) cells.declare(name);
}

void CellSurfaces::append(Particles<3> &particles, const std::vector<Vector<3>> &nodes) {
  const std::uint32_t begin = std::uint32_t(particles.size()), end = begin + std::uint32_t(nodes.size());
  particles.resize(end);
  particles.groups.push_back({begin, end, end});
  for (std::uint32_t i = begin; i < end; ++i)
    for (int d = 0; d < 3; ++d) particles.x[d][i] = nodes[i - begin][d];
  first_edge.push_back(std::uint32_t(edges.size()));
  first_triangle.push_back(std::uint32_t(triangles.size()));
  edge_table.resize(edges.size());
  triangle_table.resize(triangles.size());
  cells.resize(size());
}

void CellSurfaces::add(Particles<3> &particles, TriangleMesh mesh, const std::vector<Vector<3>> &nodes) {
  complete_closed_surface(mesh, nodes, "a cell");
  const std::uint32_t begin = std::uint32_t(particles.size());
  const std::size_t cell = size();
  for (const TriangleMesh::Edge &e : mesh.edges)
    edges.push_back({begin + e.a, begin + e.b, begin + e.c, begin + e.d});
  for (const auto &face : mesh.faces)
    triangles.push_back({begin + face[0], begin + face[1], begin + face[2]});
  append(particles, nodes);

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

void CellSurfaces::add(Particles<3> &particles, const CellSurfaces &others, const std::size_t other,
                       const std::vector<Vector<3>> &nodes) {
  const std::uint32_t begin = std::uint32_t(particles.size());
  const auto [first, last] = others.triangles_of(other);
  std::uint32_t least = others.triangles[first][0];  // their first node
  for (std::uint32_t k = first; k < last; ++k)
    for (const std::uint32_t i : others.triangles[k]) least = std::min(least, i);
  const std::uint32_t by = begin - least;  // modulo 2^32
  for (std::uint32_t k = others.first_edge[other]; k < others.first_edge[other + 1]; ++k) {
    const Edge &e = others.edges[k];
    edges.push_back({e.a + by, e.b + by, e.c + by, e.d + by});
  }
  for (std::uint32_t k = first; k < last; ++k) {
    const auto &[i, j, l] = others.triangles[k];
    triangles.push_back({i + by, j + by, l + by});
  }
  append(particles, nodes);
  take_rest(size() - 1, others, other);
}

void CellSurfaces::take_rest(const std::size_t cell, const CellSurfaces &others, const std::size_t other) {
  const auto copy = [](Table &to, const std::array<std::uint32_t, 2> there, const Table &from,
                       const std::array<std::uint32_t, 2> here, const char *name) {
    if (there[1] - there[0] != here[1] - here[0])
      throw std::logic_error("a cell cannot be at rest as one with another number of triangles is");
    const std::vector<double> &values = from.column(name);
    std::copy(values.begin() + here[0], values.begin() + here[1], to.column(name).begin() + there[0]);
  };
  for (const char *name : {"rest_length", "rest_angle", "flowed"})
    copy(edge_table, edges_of(cell), others.edge_table, others.edges_of(other), name);
  copy(triangle_table, triangles_of(cell), others.triangle_table, others.triangles_of(other), "rest_area");
  for (const char *name : {"rest_volume", "rest_area"})
    cells.column(name)[cell] = others.cells.column(name)[other];
}

void CellSurfaces::grow(const std::size_t cell, const double volume) {
  double &before = cells.column("rest_volume")[cell];
  const double s = std::cbrt(volume / before);
  before = volume;
  cells.column("rest_area")[cell] *= s * s;
  for (const char *name : {"rest_length", "flowed"}) {
    std::vector<double> &length = edge_table.column(name);
    for (std::uint32_t k = first_edge[cell]; k < first_edge[cell + 1]; ++k) length[k] *= s;
  }
  std::vector<double> &area = triangle_table.column("rest_area");
  for (std::uint32_t k = first_triangle[cell]; k < first_triangle[cell + 1]; ++k) area[k] *= s * s;
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

void CellSurfaces::archive_joints(Archive &a, Particles<3> &particles) {
  a.section("cell_joints");
  a(edges, triangles, first_edge, first_triangle, particles.groups);
  if (!a.loading()) return;
  if (first_edge.size() != particles.groups.size() + 1 || first_triangle.size() != first_edge.size() ||
      particles.groups.empty() || first_edge.back() != edges.size() ||
      first_triangle.back() != triangles.size())
    throw ArchiveError("The checkpoint's cells and their surfaces do not belong together.");
  particles.resize(particles.groups.back().end);
}
}  // namespace turgor
