// A small 3D cell for the tests of the fluid: an icosahedron's faces divided, on a sphere, filled from a
// cubic lattice.
#pragma once

#include "micro/laws/counter_random.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/sph_fluid.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace turgor::test {
struct SmallSphere {
  double radius = 50e-6;       ///< m
  unsigned int frequency = 4;  ///< parts of an edge of the icosahedron: 10 frequency^2 + 2 nodes
  double fill = 7.;            ///< particle spacings in a radius
  double jitter = 0.1;         ///< of a spacing
  double wall_jitter = 0.1;    ///< of a spacing
  bool damaged = false;        ///< keep a record of damage
  SphFluidParameters fluid;
  EquationOfState eos{1000., 6e6, -100e3};

  struct Cell {
    ParticleSystem<3> system;
    SphFluid<3> *fluid = nullptr;
    std::shared_ptr<TriangleMesh> mesh;
    std::shared_ptr<WallDamage> damage;
    double spacing = 0.;  ///< m
  };

  SmallSphere() { fluid.ordering = 0.01 * 6e6, fluid.barrier = 6e6; }

  /// The fluid fills the cell at density_ratio times rho_0.
  std::unique_ptr<Cell> make(const double density_ratio = 1.005) const {
    auto cell = std::make_unique<Cell>();
    std::vector<Vector<3>> nodes;
    cell->mesh = std::make_shared<TriangleMesh>(sphere(nodes));
    const TriangleMesh &mesh = *cell->mesh;
    const double dx = radius / fill;
    cell->spacing = dx;
    std::vector<Vector<3>> points;
    const int m = int(fill) + 1;
    for (int a = -m; a < m; ++a)
      for (int b = -m; b < m; ++b)
        for (int c = -m; c < m; ++c) {
          const Vector<3> x = dx * Vector<3>(a + 0.5, b + 0.5, c + 0.5);
          if (x.norm() < radius - 0.45 * dx) points.push_back(x);
        }
    Particles<3> &p = cell->system.particles;
    const std::size_t nw = nodes.size(), n = points.size();
    p.resize(nw + n);
    p.groups = {Group{0, std::uint32_t(nw), std::uint32_t(nw + n)}};
    for (std::size_t i = 0; i < nw + n; ++i)
      for (int d = 0; d < 3; ++d) {
        p.x[d][i] = i < nw ? radius * nodes[i][d] : points[i - nw][d];
        p.x[d][i] += (i < nw ? wall_jitter : jitter) * dx * (2. * random_uniform(7, 3 * i + d) - 1.);
        p.v[d][i] = 2. * random_uniform(8, 3 * i + d) - 1.;
      }
    const double volume = mesh.volume(p.x[0].data(), p.x[1].data(), p.x[2].data());
    const double mass = density_ratio * eos.reference_density() * volume / double(n);
    for (std::size_t i = 0; i < nw + n; ++i) p.inverse_mass[i] = 1. / mass;
    SphFluidParameters parameters = fluid;
    parameters.support = 2.6 * dx;
    parameters.skin = 0.3 * dx;
    if (damaged) cell->damage = std::make_shared<WallDamage>(1, mesh.edges.size(), mesh.faces.size());
    cell->fluid = &cell->system.add(
        std::make_unique<SphFluid<3>>(parameters, eos, std::vector<double>{mass}, cell->mesh, cell->damage));
    return cell;
  }

  /// Opens the wall: faces whose centroid is within `angle` (rad) of the +z axis are gone.
  static void open(Cell &cell, const double angle) {
    const Particles<3> &p = cell.system.particles;
    WallDamage::Cell &damage = cell.damage->cells[0];
    for (std::size_t f = 0; f < cell.mesh->faces.size(); ++f) {
      Vector<3> m = Vector<3>::Zero();
      for (const std::uint16_t k : cell.mesh->faces[f]) m += p.position(k);
      if (m.normalized()[2] > std::cos(angle)) damage.face_gone[f] = 1;
    }
    damage.bond_broken[0] = 1;
    damage.broken = 1;
    cell.fluid->forget_lists(0);
  }

 private:
  TriangleMesh sphere(std::vector<Vector<3>> &nodes) const {
    const double t = (1. + std::sqrt(5.)) / 2.;
    nodes = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
             {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    TriangleMesh mesh;
    mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    // Every face into frequency^2; what two faces share is found by its place.
    const std::vector<Vector<3>> corners = std::move(nodes);
    const auto faces = std::move(mesh.faces);
    std::map<std::array<long, 3>, std::uint16_t> known;
    nodes.clear();
    mesh.faces.clear();
    const int nu = int(frequency);
    for (const auto &face : faces) {
      const auto node = [&](const int i, const int j) {
        const Vector<3> x =
            (corners[face[0]] * (nu - i - j) + corners[face[1]] * i + corners[face[2]] * j) / nu;
        const auto found =
            known.insert({{std::lround(x[0] * 1e6), std::lround(x[1] * 1e6), std::lround(x[2] * 1e6)},
                          std::uint16_t(nodes.size())});
        if (found.second) nodes.push_back(x);
        return found.first->second;
      };
      for (int i = 0; i < nu; ++i)
        for (int j = 0; i + j < nu; ++j) {
          mesh.faces.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
          if (i + j + 1 < nu) mesh.faces.push_back({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
        }
    }
    for (Vector<3> &x : nodes) x.normalize();
    mesh.complete();
    return mesh;
  }
};
}  // namespace turgor::test
