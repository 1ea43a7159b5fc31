#include "micro/terms/sph_fluid.h"

#include "run/archive.h"
#include "run/number_text.h"
#include "micro/terms/sph_barrier.h"
#include "micro/terms/sph_scratch.h"
#include "micro/terms/sph_wall_view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace turgor {
namespace {
void eos_pressure(const void *data, const std::uint32_t n, const double *rho, double *p) {
  const EquationOfState eos = *static_cast<const EquationOfState *>(data);
  for (std::uint32_t i = 0; i < n; ++i) p[i] = eos.pressure(rho[i]);
}

/// Of an open cell: no tension.
void eos_pressure_free(const void *data, const std::uint32_t n, const double *rho, double *p) {
  const EquationOfState eos = *static_cast<const EquationOfState *>(data);
  for (std::uint32_t i = 0; i < n; ++i) p[i] = rho[i] > eos.reference_density() ? eos.pressure(rho[i]) : 0.;
}

}  // namespace

template <int dim>
SphFluid<dim>::SphFluid(const SphFluidParameters &parameters_, const EquationOfState &eos_,
                        std::vector<double> mass_,
                        std::shared_ptr<const WallDamage> damage_) requires(dim == 2)
    : parameters(parameters_), eos(eos_), mass(std::move(mass_)), damage(std::move(damage_)) {}

template <int dim>
SphFluid<dim>::SphFluid(const SphFluidParameters &parameters_, const EquationOfState &eos_,
                        std::vector<double> mass_, std::shared_ptr<const TriangleMesh> mesh_,
                        std::shared_ptr<const WallDamage> damage_) requires(dim == 3)
    : parameters(parameters_),
      eos(eos_),
      mass(std::move(mass_)),
      mesh(std::move(mesh_)),
      damage(std::move(damage_)) {
  parameters.depth = 1.;
}

template <int dim>
void SphFluid<dim>::declare(Particles<dim> &particles) {
  if (parameters.fourth_order && damage)
    throw std::invalid_argument(
        "SPH fluid: a wall that can fail needs the ordinary kernel (wendland); what the fourth-order "
        "one gives beside a hole is not known");
  for (std::size_t group = 0; group < particles.groups.size(); ++group) {
    const Group &g = particles.groups[group];
    if (std::max(g.fluid_count(), g.wall_count()) > 65534)
      throw std::invalid_argument("SPH fluid: cell " + number_text(group) + " has " +
                                  number_text(g.fluid_count()) + " fluid particles and " +
                                  number_text(g.wall_count()) +
                                  " wall nodes; the neighbour lists number at most 65534 of each");
    if (dim == 3 && g.wall_count() != mesh->nodes)
      throw std::invalid_argument("SPH fluid: cell " + number_text(group) + " has " +
                                  number_text(g.wall_count()) + " wall nodes, its mesh of triangles " +
                                  number_text(mesh->nodes));
    const std::size_t faces = dim == 2 ? g.wall_count() : mesh->faces.size();
    if (damage && damage->cells.at(group).face_gone.size() != faces)
      throw std::invalid_argument("SPH fluid: the wall of cell " + number_text(group) + " has " +
                                  number_text(faces) + " faces, its record of damage " +
                                  number_text(damage->cells[group].face_gone.size()));
  }
  particles.declare("density");
  particles.declare("pressure");
  particles.declare("wall_share");
  cells.assign(particles.groups.size(), Cell());
}

template <int dim>
void SphFluid<dim>::set_particle_mass(Particles<dim> &particles, const std::size_t group,
                                      const double value) {
  mass[group] = value;
  const Group &g = particles.groups[group];
  for (std::uint32_t i = g.fluid; i < g.end; ++i) particles.inverse_mass[i] = 1. / value;
}

template <int dim>
void SphFluid<dim>::build(const Group &g, const std::size_t number) {
  Cell &cell = cells[number];
  const double reach = parameters.support + parameters.skin;
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  const std::vector<unsigned char> *gone = open(number) ? &damage->cells[number].face_gone : nullptr;
  cell.built = true;
  if (!cell.built_at
           .finite()) {  // no neighbours: the scene sees the positions themselves and says that it diverged
    cell.lists.fluid.clear(n);
    cell.lists.wall.clear(n);
    return;
  }
  cell.lists.fluid.build(cell.built_at, nw, reach);
  if constexpr (dim == 2)
    cell.lists.wall.build(cell.built_at, nw, reach, gone);
  else
    cell.lists.wall.build(cell.built_at, nw, *mesh, reach, parameters.skin,
                          parameters.barrier > 0. ? barrier_range * parameters.support : 0., gone);
}

template <int dim>
void SphFluid<dim>::add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group) {
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.fluid_count();
  if (n == 0) return;
  Cell &cell = cells[group];
  if (cell.built_at.stale(particles, g, parameters.skin)) {
    cell.built_at.take(particles.x, g);
    cell.built = false;
    ++cell.builds;  // not those that a loaded checkpoint, an asked-for look or a break make again from the
                    // same positions
  }
  if (!cell.built) build(g, group);

  if (!cell.impulses.within_step) cell.impulses.virial_known = false;  // velocities may be others
  const std::size_t rows = SphScratch::round_up(std::size_t(n + 1) * sph::row_doubles);
  WallView<dim> wall(cell.lists.wall, g, {parameters.depth, false, mesh.get()});
  thread_local SphScratch scratch;
  double *memory = scratch.get(rows + SphScratch::round_up(n) + wall.doubles());

  sph::CellView<dim> view;
  view.n = n;
  view.rows = memory;
  view.push = memory + rows;
  wall.attach(view, particles, view.push + SphScratch::round_up(n));
  view.support = parameters.support;
  view.mass = mass[group];
  view.depth = parameters.depth;
  view.eos = &eos_pressure;
  view.eos_data = &eos;
  view.neighbours = cell.lists.fluid.neighbours.data();
  view.first_neighbour = cell.lists.fluid.first_neighbour.data();
  view.rho = particles.field("density").data() + g.fluid;
  view.pressure = particles.field("pressure").data() + g.fluid;
  view.gamma = particles.field("wall_share").data() + g.fluid;
  for (int d = 0; d < dim; ++d) {
    view.x[d] = particles.x[d].data() + g.fluid;
    view.f[d] = particles.f[d].data() + g.fluid;
  }
  view.fourth_order = parameters.fourth_order;
  view.layer_linear = parameters.layer.linear;
  view.layer_square = parameters.layer.square;
  view.open = open(group);
  if (view.open) {
    view.eos = &eos_pressure_free;
    view.scale = cell.scale;
  } else if (parameters.exact_volume) {
    view.volume = std::max(0., wall.volume());
    view.ordering = view.volume > 0. ? parameters.ordering : 0.;  // a wall turned inside out encloses nothing
  }

  const sph::Sweeps<dim> &sweeps = sph::sweeps<dim>();
  sweeps.density(view);
  sweeps.force(view);
  cell.crossed = view.crossed;
  cell.scale = view.scale;
  cell.ordering_energy = view.ordering * view.volume * (1. - view.scale);
  wall.collect(view, view.mean_pressure - view.ordering, particles);
  if (parameters.barrier > 0.) {
    const double range = barrier_range * parameters.support,
                 height = parameters.barrier * mass[group] / eos.reference_density();
    if constexpr (dim == 2)
      cell.barrier_energy = add_barrier(cell.lists.wall, particles, g, range, height);
    else
      cell.barrier_energy = add_barrier(cell.lists.wall, particles, g, *mesh, range, height);
  }
}

template <int dim>
double SphFluid<dim>::energy(const Particles<dim> &particles, const Box<dim> &,
                             const std::size_t group) const {
  const Group &g = particles.groups[group];
  const std::vector<double> &rho = particles.field("density");
  const bool free = open(group);
  double total = cells[group].ordering_energy + cells[group].barrier_energy;
  for (std::uint32_t i = g.fluid; i < g.end; ++i)
    if (!free || !(rho[i] <= eos.reference_density())) total += mass[group] * eos.energy(rho[i]);
  return total;
}

template <int dim>
void SphFluid<dim>::forget_lists() {
  for (Cell &cell : cells) {
    cell.built_at.forget();
    cell.impulses = {};
  }
}

template <int dim>
std::size_t SphFluid<dim>::crossed() const {
  std::size_t total = 0;
  for (const Cell &cell : cells) total += cell.crossed;
  return total;
}

template <int dim>
double SphFluid<dim>::heat() const {
  double sum = 0.;
  for (const Cell &cell : cells) sum += cell.heat;
  return sum;
}

template <int dim>
std::size_t SphFluid<dim>::list_builds() const {
  std::size_t total = 0;
  for (const Cell &cell : cells) total += cell.builds;
  return total;
}

template <int dim>
double SphFluid<dim>::mean_neighbours(const Particles<dim> &particles) const {
  std::size_t pairs = 0, n = 0;
  for (std::size_t group = 0; group < cells.size(); ++group) {
    const Group &g = particles.groups[group];
    const FluidNeighbours &lists = cells[group].lists.fluid;
    n += g.fluid_count();
    for (std::uint32_t i = 0; i + 1 < lists.first_neighbour.size(); ++i)
      for (std::uint32_t k = lists.first_neighbour[i]; k < lists.first_neighbour[i + 1]; ++k)
        if (lists.neighbours[k] < g.fluid_count())
          pairs +=
              (particles.position(g.fluid + lists.neighbours[k]) - particles.position(g.fluid + i)).norm() <
              parameters.support;
  }
  return n > 0 ? double(pairs) / double(n) : 0.;
}

template <int dim>
std::size_t SphFluid<dim>::memory_bytes() const {
  std::size_t bytes = 0;
  for (const Cell &cell : cells) bytes += cell.lists.memory_bytes() + cell.built_at.memory_bytes();
  return bytes;
}

template <int dim>
void SphFluid<dim>::archive(Archive &a, Particles<dim> &particles) {
  a.section("SPH fluid");
  a.fixed(mass);
  for (std::size_t group = 0; group < cells.size(); ++group) {
    Cell &cell = cells[group];
    a(cell.built_at);
    if (damage) a(cell.scale);
    a(cell.impulses, cell.heat);
    if (!a.loading()) continue;
    set_particle_mass(particles, group, mass[group]);
    cell.built = false;  // built from there at the next forces, when the damage is known as well
  }
}

template class SphFluid<2>;
template class SphFluid<3>;
}  // namespace turgor
