// The fluid of a closed cell as one pressure: what SPH particles amount to when nothing flows.
//
//   p = p(m/V),  E = m e(m/V)       equation_of_state.h; V: volume inside the wall's polygon times depth, or
//                polyhedron
//   f = p dV/dx                     on the wall nodes
//
// With hold_pressure() water flows freely through the wall at one pressure: E = -p V.
//
// A group holds wall nodes only. In: masses (kg) per group, depth (m, 2D). Out: forces (N), pressure (Pa),
// volume (m^3).
#pragma once

#include "micro/geometry/triangle_mesh.h"
#include "run/archive.h"
#include "micro/engine/term.h"
#include "micro/laws/equation_of_state.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace turgor {
template <int dim>
class EnclosedFluid final : public Term<dim> {
 public:
  /// mesh: of every cell (3D), none in 2D, where the wall nodes of a group are a counter-clockwise ring.
  EnclosedFluid(const EquationOfState &eos_, std::vector<double> mass_, const double depth_,
                std::shared_ptr<const TriangleMesh> mesh_)
      : eos(eos_), mass(std::move(mass_)), depth(depth_), mesh(std::move(mesh_)) {}

  std::string name() const override { return "enclosed_fluid"; }
  void declare(Particles<dim> &) override {}

  double volume(const Particles<dim> &p, const std::size_t group) const {
    const Group &g = p.groups[group];
    if constexpr (dim == 3)
      return mesh->volume(p.x[0].data() + g.begin, p.x[1].data() + g.begin, p.x[2].data() + g.begin);
    else {
      double twice = 0.;
      for (std::uint32_t a = g.begin; a < g.fluid; ++a) {
        const std::uint32_t b = a + 1 < g.fluid ? a + 1 : g.begin;
        twice += p.x[0][a] * p.x[1][b] - p.x[0][b] * p.x[1][a];
      }
      return 0.5 * twice * depth;
    }
  }
  double pressure(const Particles<dim> &p, const std::size_t group) const {
    return held ? *held : eos.pressure(mass[group] / volume(p, group));
  }
  void hold_pressure(const double pressure) { held = pressure; }  ///< Pa, of all cells from now on
  double cell_mass(const std::size_t group) const { return mass[group]; }
  void set_cell_mass(const std::size_t group, const double value) { mass[group] = value; }

  void add_forces(Particles<dim> &p, const Box<dim> &, const std::size_t group) override {
    push(p, group, pressure(p, group), p.f);
  }

  double energy(const Particles<dim> &p, const Box<dim> &, const std::size_t group) const override {
    return held ? -*held * volume(p, group) : mass[group] * eos.energy(mass[group] / volume(p, group));
  }

  /// One stiff mode, the swelling of the cell: (-dp/dV) sum (dV/dx)^2/m; none where the pressure is held.
  Rates rates(const Particles<dim> &p) const override {
    Rates bound;
    if (held) return bound;
    for (std::size_t group = 0; group < p.groups.size(); ++group) {
      const Group &g = p.groups[group];
      typename Particles<dim>::Components slope;
      for (auto &component : slope) component.assign(p.size(), 0.);
      push(p, group, 1., slope);
      const double V = volume(p, group), rho = mass[group] / V;
      double sum = 0.;
      for (std::uint32_t i = g.begin; i < g.fluid; ++i)
        for (int d = 0; d < dim; ++d) sum += slope[d][i] * slope[d][i] * p.inverse_mass[i];
      bound.wall.frequency_squared = std::max(bound.wall.frequency_squared, eos.slope(rho) * rho / V * sum);
    }
    return bound;
  }

  void archive(Archive &a, Particles<dim> &) override {
    a.section("enclosed fluid");
    a.fixed(mass);
  }

 private:
  /// force += pressure dV/dx
  void push(const Particles<dim> &p, const std::size_t group, const double now,
            typename Particles<dim>::Components &force) const {
    const Group &g = p.groups[group];
    if constexpr (dim == 3) {
      double *f[3];
      for (int d = 0; d < 3; ++d) f[d] = force[d].data() + g.begin;
      for (const auto &face : mesh->faces) {
        const Vector<3> a = p.position(g.begin + face[0]);
        const Vector<3> push =
            now / 6. * (p.position(g.begin + face[1]) - a).cross(p.position(g.begin + face[2]) - a);
        for (const auto node : face)
          for (int d = 0; d < 3; ++d) f[d][node] += push[d];
      }
    } else
      for (std::uint32_t a = g.begin; a < g.fluid; ++a) {
        const std::uint32_t b = a + 1 < g.fluid ? a + 1 : g.begin;
        const double push = 0.5 * now * depth, ex = p.x[0][b] - p.x[0][a], ey = p.x[1][b] - p.x[1][a];
        for (const std::uint32_t node : {a, b}) {
          force[0][node] += push * ey;
          force[1][node] -= push * ex;
        }
      }
  }

  EquationOfState eos;
  std::vector<double> mass;
  double depth;
  std::shared_ptr<const TriangleMesh> mesh;
  std::optional<double> held;  ///< Pa
};
}  // namespace turgor
