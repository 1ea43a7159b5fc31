#include "micro/terms/surface_points.h"

#include "run/parallel.h"

#include <Eigen/Geometry>

namespace turgor {
SurfacePoints::SurfacePoints(std::shared_ptr<const CellSurfaces> surfaces_)
    : surfaces(std::move(surfaces_)) {}

void SurfacePoints::update(const Particles<3> &particles, const unsigned int threads) {
  const std::size_t cells = surfaces->size();
  first.resize(cells + 1);
  first_node.resize(cells);
  node_count.resize(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto [begin, end] = surfaces->triangles_of(cell);
    first_node[cell] = particles.groups[cell].begin;
    node_count[cell] = particles.groups[cell].wall_count();
    first[cell + 1] = first[cell] + node_count[cell] + (end - begin);
  }
  position.resize(first[cells]);
  area.resize(first[cells]);
  normal.resize(surfaces->triangles.size());
  for_chunks(threads, Chunks(cells, 1), [&](std::size_t from, std::size_t to) {
    for (std::size_t cell = from; cell < to; ++cell) {
      const std::uint32_t nodes = node_count[cell];
      for (std::uint32_t i = 0; i < nodes; ++i) {
        position[first[cell] + i] = particles.position(first_node[cell] + i);
        area[first[cell] + i] = 0.;
      }
      const auto [begin, end] = surfaces->triangles_of(cell);
      for (std::uint32_t k = begin; k < end; ++k) {
        const std::uint32_t at = first[cell] + nodes + (k - begin);
        std::uint32_t corner[3];
        for (int m = 0; m < 3; ++m)
          corner[m] = first[cell] + surfaces->triangles[k][std::size_t(m)] - first_node[cell];
        const Vector<3> &a = position[corner[0]], &b = position[corner[1]], &c = position[corner[2]];
        const Vector<3> twice = twice_area(a, b, c);
        const double size = twice.norm();
        normal[k] = twice / size;
        position[at] = (a + b + c) / 3.;
        area[at] = 0.375 * size;
        for (const std::uint32_t m : corner) area[m] += size / 24.;
      }
    }
  });
}

void SurfacePoints::add_forces(Particles<3> &particles, const std::size_t cell,
                               const std::span<const Load> loads) const {
  const std::uint32_t nodes = node_count[cell], first_of_all = first_node[cell];
  for (std::uint32_t i = 0; i < nodes; ++i) add_force(particles, first_of_all + i, loads[i].force);
  const auto [begin, end] = surfaces->triangles_of(cell);
  for (std::uint32_t k = begin; k < end; ++k) {
    const Load &own = loads[nodes + (k - begin)];
    const CellSurfaces::Triangle &corner = surfaces->triangles[k];
    double sigma = 0.75 * own.energy;
    for (const std::uint32_t node : corner) sigma += loads[node - first_of_all].energy / 12.;
    if (sigma == 0. && own.force == Vector<3>::Zero()) continue;
    const Vector<3> *const x = &position[first[cell]];
    for (std::size_t m = 0; m < 3; ++m) {
      const Vector<3> across = x[corner[(m + 2) % 3] - first_of_all] - x[corner[(m + 1) % 3] - first_of_all];
      add_force(particles, corner[m], own.force / 3. - 0.5 * sigma * normal[k].cross(across));
    }
  }
}
}  // namespace turgor
