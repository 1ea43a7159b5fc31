#include "micro/terms/sph_fluid.h"

#include "micro/engine/binary.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace turgor
{
namespace
{
void eos_pressure(const void *data, const std::uint32_t n, const double *rho, double *p)
{
  const EquationOfState eos = *static_cast<const EquationOfState *>(data);
  for (std::uint32_t i = 0; i < n; ++i)
    p[i] = eos.pressure(rho[i]);
}

/// Scratch of one thread, grown to the largest cell it met.
class Scratch
{
public:
  double *get(std::size_t doubles)
  {
    if (doubles > size)
      {
        size = doubles + doubles / 2;
        memory.reset(static_cast<double *>(std::aligned_alloc(64, (size * sizeof(double) + 63) / 64 * 64)));
        if (!memory)
          throw std::bad_alloc();
      }
    return memory.get();
  }

private:
  struct Free
  {
    void operator()(double *p) const { std::free(p); }
  };
  std::unique_ptr<double, Free> memory;
  std::size_t size = 0;
};

/// Area inside a closed ring run counterclockwise whose first node is repeated at its end, m^2.
double ring_area(const double *x, const double *y, const std::uint32_t n)
{
  double twice = 0.;
  for (std::uint32_t k = 0; k < n; ++k)
    twice += (x[k] - x[0]) * (y[k + 1] - y[0]) - (x[k + 1] - x[0]) * (y[k] - y[0]);
  return 0.5 * twice;
}

std::size_t round_up(std::size_t n) { return (n + 7) / 8 * 8; }
} // namespace

SphFluid::SphFluid(const SphFluidParameters &parameters_, const EquationOfState &eos_, std::vector<double> mass_)
  : parameters(parameters_)
  , eos(eos_)
  , mass(std::move(mass_))
{}

void SphFluid::declare(Particles<2> &particles)
{
  particles.declare("density");
  particles.declare("pressure");
  particles.declare("wall_share");
  cells.assign(particles.groups.size(), Cell());
}

void SphFluid::set_particle_mass(Particles<2> &particles, const std::size_t group, const double value)
{
  mass[group] = value;
  const Group &g = particles.groups[group];
  for (std::uint32_t i = g.fluid; i < g.end; ++i)
    particles.inverse_mass[i] = 1. / value;
}

void SphFluid::build(const Group &g, Cell &cell) const
{
  cell.lists.build(cell.built_at, g.wall_count(), parameters.support + parameters.skin);
  ++cell.builds;
}

void SphFluid::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group)
{
  const Group &g = particles.groups[group];
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  if (n == 0)
    return;
  Cell &cell = cells[group];
  if (cell.built_at.stale(particles, g, parameters.skin))
    {
      cell.built_at.take(particles.x, g);
      build(g, cell);
    }

  thread_local Scratch scratch;
  const std::size_t ring = round_up(2 * nw + sph::list_padding + 1), rows = std::size_t(n + 1) * sph::row_doubles;
  const std::size_t half = std::size_t(4) * sph::list_padding * cell.lists.chunks;
  const std::size_t arc_stride = round_up(cell.lists.arcs.size());
  double *memory = scratch.get(rows + 2 * half + 8 * ring + 5 * arc_stride);
  double *wall = memory + rows + 2 * half;

  sph::CellView view;
  view.n = n;
  view.n_wall = nw;
  view.rows = memory;
  view.scratch = memory + rows;
  view.scratch_half = std::uint32_t(half);
  view.arc_ends = wall + 8 * ring;
  view.arc_stride = std::uint32_t(arc_stride);
  view.support = parameters.support;
  view.mass = mass[group];
  view.depth = parameters.depth;
  view.viscosity = parameters.viscosity;
  view.eos = &eos_pressure;
  view.eos_data = &eos;
  view.neighbours = cell.lists.neighbours.data();
  view.first_neighbour = cell.lists.first_neighbour.data();
  view.arcs = cell.lists.arcs.data();
  view.first_arc = cell.lists.first_arc.data();
  view.rho = particles.field("density").data() + g.fluid;
  view.pressure = particles.field("pressure").data() + g.fluid;
  view.gamma = particles.field("wall_share").data() + g.fluid;

  const bool viscous = parameters.viscosity > 0.;
  for (int d = 0; d < 2; ++d)
    {
      view.x[d] = particles.x[d].data() + g.fluid;
      view.f[d] = particles.f[d].data() + g.fluid;
      double *ring_x = wall + (4 * d) * ring, *ring_v = ring_x + ring, *ring_f = ring_v + ring, *ring_next = ring_f + ring;
      const double *x = particles.x[d].data() + g.begin;
      const std::size_t used = 2 * nw + sph::list_padding + 1;
      for (std::size_t k = 0, node = 0; k < used; ++k, node = node + 1 < nw ? node + 1 : 0)
        ring_x[k] = x[node];
      std::fill(ring_f, ring_f + 2 * ring, 0.);
      if (viscous)
        {
          const double *v = particles.v[d].data();
          view.v[d] = v + g.fluid;
          for (std::size_t k = 0, node = 0; k < used; ++k, node = node + 1 < nw ? node + 1 : 0)
            ring_v[k] = v[g.begin + node];
        }
      view.wall_x[d] = ring_x;
      view.wall_v[d] = ring_v;
      view.wall_f[d] = ring_f;
      view.wall_f_next[d] = ring_next;
    }

  if (parameters.exact_volume)
    {
      view.volume = std::max(0., parameters.depth * ring_area(view.wall_x[0], view.wall_x[1], nw));
      view.ordering = view.volume > 0. ? parameters.ordering : 0.; // a wall turned inside out encloses nothing
    }
  const sph::Sweeps &sweeps = sph::sweeps();
  sweeps.density(view);
  sweeps.force(view);
  cell.crossed = view.crossed;
  cell.ordering_energy = view.ordering * view.volume * (1. - view.scale);

  const double push = 0.5 * (view.mean_pressure - view.ordering) * parameters.depth; // times 2 dA/dx of a node
  for (int d = 0; d < 2; ++d)
    {
      double *f = particles.f[d].data() + g.begin;
      const double *across = view.wall_x[1 - d], sign = d == 0 ? push : -push;
      for (std::uint32_t k = 0; k < nw; ++k)
        f[k] += sign * (across[k + 1] - across[k > 0 ? k - 1 : nw - 1]);
      const double *own = view.wall_f[d], *next = view.wall_f_next[d];
      const std::size_t used = 2 * nw + sph::list_padding;
      for (std::size_t k = 0, node = 0; k < used; ++k)
        {
          f[node] += own[k];
          node = node + 1 < nw ? node + 1 : 0;
          f[node] += next[k];
        }
    }
}

double SphFluid::energy(const Particles<2> &particles, const Box<2> &, const std::size_t group) const
{
  const Group &g = particles.groups[group];
  const std::vector<double> &rho = particles.field("density");
  double total = cells[group].ordering_energy;
  for (std::uint32_t i = g.fluid; i < g.end; ++i)
    total += mass[group] * eos.energy(rho[i]);
  return total;
}

Rates SphFluid::rates(const Particles<2> &particles) const
{
  Rates bound;
  const double R = parameters.support, rho = eos.reference_density(), c = eos.sound_speed(1.05 * rho);
  // Stiffest acoustic mode of the pair sums: wave number about 6.5 / R.
  bound.fluid.frequency_squared = 6.5 * 6.5 * c * c / (R * R);
  // Wendland C2, continuous limit: sum V |W'|/r = 14/R^2; the central pair drag takes half of
  // it in one direction, chi mu/2 = 8 mu, and the highest mode moves neighbours oppositely.
  bound.fluid.drag = 2. * 8. * 7. * parameters.viscosity / (rho * R * R);
  if (particles.groups.empty())
    return bound;
  const Group &g = particles.groups.front(); // all cells start as copies
  const std::uint32_t n = g.wall_count();
  if (n == 0)
    return bound;
  std::vector<double> x, y;
  double lightest = 0., length = 0., squares = 0.; // inverse mass of the lightest node; sums over the faces
  for (std::uint32_t k = 0; k <= n; ++k)
    {
      const std::uint32_t node = g.begin + k % n;
      x.push_back(particles.x[0][node]);
      y.push_back(particles.x[1][node]);
      lightest = std::max(lightest, particles.inverse_mass[node]);
      const double face = k > 0 ? std::hypot(x[k] - x[k - 1], y[k] - y[k - 1]) : 0.;
      length += face;
      squares += face * face;
    }
  // All nodes together against the fluid's bulk modulus: B depth sum_k |dA/dx_k|^2 / (A m_node).
  if (parameters.exact_volume)
    bound.wall.frequency_squared = rho * c * c * parameters.depth * squares / ring_area(x.data(), y.data(), n) * lightest;
  // No slip drags the wall's light nodes: mu z0 l over the least gap that counts, half a
  // spacing (doc/validation.md has the measured limit beside this bound).
  bound.wall.drag = parameters.viscosity * parameters.depth * (length / n) * lightest / (0.5 * R / 2.6);
  return bound;
}

void SphFluid::forget_lists()
{
  for (Cell &cell : cells)
    cell.built_at.forget();
}

std::size_t SphFluid::crossed() const
{
  std::size_t total = 0;
  for (const Cell &cell : cells)
    total += cell.crossed;
  return total;
}

std::size_t SphFluid::list_builds() const
{
  std::size_t total = 0;
  for (const Cell &cell : cells)
    total += cell.builds;
  return total;
}

double SphFluid::mean_neighbours(const Particles<2> &particles) const
{
  std::size_t pairs = 0, n = 0;
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      const Group &g = particles.groups[group];
      const Cell &cell = cells[group];
      n += g.fluid_count();
      for (std::uint32_t i = 0; i + 1 < cell.lists.first_neighbour.size(); ++i)
        for (std::uint32_t k = cell.lists.first_neighbour[i]; k < cell.lists.first_neighbour[i + 1]; ++k)
          if (cell.lists.neighbours[k] < g.fluid_count())
            pairs += (particles.position(g.fluid + cell.lists.neighbours[k]) - particles.position(g.fluid + i)).norm()
                     < parameters.support;
    }
  return n > 0 ? double(pairs) / double(n) : 0.;
}

std::size_t SphFluid::memory_bytes() const
{
  std::size_t bytes = 0;
  for (const Cell &cell : cells)
    bytes += cell.lists.memory_bytes() + cell.built_at.memory_bytes();
  return bytes;
}

void SphFluid::save(std::ostream &out, const Particles<2> &) const
{
  write_binary(out, mass);
  for (const Cell &cell : cells)
    cell.built_at.save(out);
}

void SphFluid::load(std::istream &in, Particles<2> &particles)
{
  read_binary(in, mass);
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      Cell &cell = cells[group];
      cell.built_at.load(in);
      set_particle_mass(particles, group, mass[group]);
      if (cell.built_at.known() && particles.groups[group].fluid_count() > 0)
        build(particles.groups[group], cell);
    }
}
} // namespace turgor
