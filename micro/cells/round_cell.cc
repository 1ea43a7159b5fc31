#include "micro/cells/round_cell.h"

#include "micro/cells/sph_parenchyma.h"
#include "micro/laws/counter_random.h"
#include "run/start_disturbance.h"
#include "micro/terms/thesis_fluid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;

/// n points spread evenly but without order in a ball (disc) of the given radius, m.
template <int dim>
std::vector<Vector<dim>> scattered(const std::size_t n, const double radius, const double spacing,
                                   const unsigned int seed) {
  const int reach = int(std::ceil(radius / spacing * 1.5)) + 2;
  std::vector<Vector<dim>> points;
  const double a = dim == 2 ? spacing * std::sqrt(2. / std::sqrt(3.)) : spacing * std::cbrt(4.);
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      if constexpr (dim == 2)
        points.push_back({a * (i + 0.5 * (j & 1)) + 0.21 * a, a * (0.5 * std::sqrt(3.) * j + 0.13)});
      else
        for (int k = -reach; k <= reach; ++k)
          if (((i + j + k) & 1) == 0)  // fcc of half the cube's side
            points.push_back(Vector<3>(0.5 * a * (i + 0.17), 0.5 * a * (j + 0.31), 0.5 * a * (k + 0.07)));
  std::stable_sort(points.begin(), points.end(), [](const Vector<dim> &p, const Vector<dim> &q) {
    return p.squaredNorm() < q.squaredNorm();
  });
  if (points.size() < n) throw std::logic_error("too few lattice points");
  points.resize(n);
  const double scale = (radius - 0.4 * spacing) / points.back().norm();
  for (std::size_t i = 0; i < n; ++i) {
    Vector<dim> jitter;
    for (int d = 0; d < dim; ++d) jitter[d] = 0.3 * spacing * (random_uniform(seed, dim * i + d) - 0.5);
    points[i] = scale * points[i] + jitter;
    const double out = points[i].norm();
    if (out > radius - 0.3 * spacing) points[i] *= (radius - 0.3 * spacing) / out;
  }
  return points;
}

template <int dim>
void add_sph_fluid(RoundCell<dim> &cell, const EquationOfState &eos, const double spacing,
                   const double mass) {
  const RoundCellParameters &p = cell.parameters;
  SphFluidParameters fluid;
  fluid.support = p.support_ratio * spacing;
  fluid.skin = p.skin_ratio * spacing;
  fluid.depth = p.depth;
  fluid.viscosity = p.fluid_viscosity;
  fluid.ordering = p.ordering * p.fluid_modulus;
  fluid.fourth_order = p.fourth_order;
  if (!fluid.fourth_order) fluid.layer = wall_layer<dim>(p.support_ratio);
  fluid.barrier =
      cell.damage ? p.fluid_modulus : 0.;  // or an opened cell leaks through what is left of its wall
  if constexpr (dim == 3)
    cell.sph = &cell.system.add(
        std::make_unique<SphFluid<3>>(fluid, eos, std::vector<double>(1, mass), cell.mesh, cell.damage));
  else
    cell.sph = &cell.system.add(
        std::make_unique<SphFluid<2>>(fluid, eos, std::vector<double>(1, mass), cell.damage));
  cell.fluid = cell.sph;
}

/// Range and strength of the wall's repulsion as in the parenchyma's baseline (lennard_jones_wall.h).
template <int dim>
void add_thesis_fluid(RoundCell<dim> &cell, const EquationOfState &eos, const double spacing,
                      const double mass) {
  const RoundCellParameters &p = cell.parameters;
  const double range = 1.5 * spacing, strength = 4., wall_nodes = cell.group().wall_count();
  ThesisFluidParameters fluid;
  fluid.support = p.support_ratio * spacing;
  fluid.skin = p.skin_ratio * spacing;
  fluid.viscosity = p.fluid_viscosity;
  fluid.initial_density = p.fluid_density;
  std::vector<std::array<std::uint16_t, 3>> faces;
  if constexpr (dim == 3) {
    fluid.holding_force = p.turgor * spacing * spacing;
    for (const auto &face : cell.mesh->faces)
      faces.push_back({std::uint16_t(face[0]), std::uint16_t(face[1]), std::uint16_t(face[2])});
    const double node_area = 4. * pi * p.radius * p.radius / wall_nodes;
    cell.fluid = &cell.system.add(std::make_unique<ThesisFluid<3>>(
        fluid, eos, LennardJonesWall::holding_net(p.turgor, spacing, node_area, range, strength),
        std::vector<double>(1, mass), faces));
  } else {
    fluid.depth = p.depth;
    fluid.holding_force = p.turgor * spacing * p.depth;
    cell.fluid = &cell.system.add(std::make_unique<ThesisFluid<2>>(
        fluid, eos,
        LennardJonesWall::holding(p.turgor, spacing, 2. * pi * p.radius / wall_nodes, p.depth, range,
                                  strength),
        std::vector<double>(1, mass), faces));
  }
}

template <int dim>
void lay_wall(RoundCell<dim> &cell, const std::uint32_t fluid_particles) {
  const RoundLayout<dim> &layout = cell.layout;
  const std::uint32_t count = std::uint32_t(layout.nodes.size());
  Particles<dim> &particles = cell.system.particles;
  particles.resize(count + fluid_particles);
  particles.groups.push_back({0, count, count + fluid_particles});
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int d = 0; d < dim; ++d) particles.x[d][i] = layout.nodes[i][d];
    particles.inverse_mass[i] = 1. / layout.node_mass[i];
  }
  if constexpr (dim == 3) {
    cell.mesh = layout.mesh;
    cell.wall = &cell.system.add(make_net_wall(layout));
  } else
    cell.wall = &cell.system.add(std::make_unique<RingWall>(layout.parameters.wall_law(), ring_shapes(layout),
                                                            layout.spacing, layout.node_mass[0]));
}

template <int dim>
void fill(RoundCell<dim> &cell) {
  const RoundCellParameters &p = cell.parameters;
  const EquationOfState eos = p.equation_of_state();
  Particles<dim> &particles = cell.system.particles;
  const std::uint32_t nw = cell.group().wall_count(), nf = cell.group().fluid_count();
  double content;  // kg
  if constexpr (dim == 3)
    content = cell.layout.fluid_mass;
  else
    content = cell.layout.fluid_mass[0];
  if (p.has_particles()) {
    const double volume = cell.volume(),
                 spacing = dim == 3 ? std::cbrt(volume / nf) : std::sqrt(volume / p.depth / nf);
    const auto points = scattered<dim>(nf, cell.rest_radius, spacing, p.seed);
    const double mass = content / nf;
    for (std::uint32_t i = 0; i < nf; ++i) {
      for (int d = 0; d < dim; ++d) particles.x[d][nw + i] = points[i][d];
      particles.inverse_mass[nw + i] = 1. / mass;
    }
    if (p.fluid == CellFilling::thesis)
      add_thesis_fluid(cell, eos, spacing, mass);
    else
      add_sph_fluid(cell, eos, spacing, mass);
  } else if (p.fluid == CellFilling::pressure)
    cell.enclosed = &cell.system.add(
        std::make_unique<EnclosedFluid<dim>>(eos, std::vector<double>(1, content), p.depth, cell.mesh));
}
}  // namespace

template <int dim>
std::unique_ptr<RoundCell<dim>> make_round_cell(const RoundCellParameters &p, const bool can_fail) {
  if (can_fail && p.fluid == CellFilling::thesis)
    throw std::invalid_argument(
        "Cell/Fluid is thesis, whose wall cannot open; a wall that fails needs Cell/Fluid = sph or "
        "pressure.");
  auto cell = std::make_unique<RoundCell<dim>>(p, round_layout<dim>(p));
  lay_wall(*cell, p.has_particles() ? p.fluid_particles : 0);
  if (can_fail) {
    std::size_t faces = cell->bonds();
    if constexpr (dim == 3) faces = cell->mesh->faces.size();
    cell->damage = std::make_shared<WallDamage>(1, cell->bonds(), faces);
    cell->wall->set_damage(cell->damage);
  }
  fill(*cell);
  begin_at(cell->system.particles.x);
  return cell;
}

template std::unique_ptr<RoundCell<2>> make_round_cell<2>(const RoundCellParameters &, bool);
template std::unique_ptr<RoundCell<3>> make_round_cell<3>(const RoundCellParameters &, bool);
}  // namespace turgor
