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

bool SphFluid::moved_too_far(const Particles<2> &particles, const Group &g, const Cell &cell) const
{
  const std::uint32_t n = g.end - g.begin;
  if (cell.built_at[0].size() != n)
    return true;
  double mean[2];
  for (int d = 0; d < 2; ++d)
    {
      const double *x = particles.x[d].data() + g.begin, *old = cell.built_at[d].data();
      double sums[8] = {};
      const std::uint32_t nw = g.wall_count() / 8 * 8;
      for (std::uint32_t i = 0; i < nw; i += 8)
        for (int l = 0; l < 8; ++l)
          sums[l] += x[i + l] - old[i + l];
      double total = 0.;
      for (const double s : sums)
        total += s;
      mean[d] = nw > 0 ? total / nw : 0.;
    }
  const double *x = particles.x[0].data() + g.begin, *y = particles.x[1].data() + g.begin;
  const double *ox = cell.built_at[0].data(), *oy = cell.built_at[1].data();
  double most[8] = {};
  std::uint32_t i = 0;
  for (; i + 8 <= n; i += 8)
    for (int l = 0; l < 8; ++l)
      {
        const double dx = x[i + l] - ox[i + l] - mean[0], dy = y[i + l] - oy[i + l] - mean[1];
        const double d2 = dx * dx + dy * dy;
        most[l] = d2 > most[l] ? d2 : most[l];
      }
  for (; i < n; ++i)
    {
      const double dx = x[i] - ox[i] - mean[0], dy = y[i] - oy[i] - mean[1];
      most[0] = std::max(most[0], dx * dx + dy * dy);
    }
  const double limit = 0.25 * parameters.skin * parameters.skin;
  return !(*std::max_element(most, most + 8) < limit);
}

void SphFluid::build(const Group &g, Cell &cell) const
{
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  const double *wx = cell.built_at[0].data(), *wy = cell.built_at[1].data();
  const double *x = wx + nw, *y = wy + nw;
  const double reach = parameters.support + parameters.skin, reach2 = reach * reach;

  // Bins of the reach over the bounding box.
  double lo[2] = {x[0], y[0]}, hi[2] = {x[0], y[0]};
  for (std::uint32_t i = 1; i < n; ++i)
    {
      lo[0] = std::min(lo[0], x[i]);
      hi[0] = std::max(hi[0], x[i]);
      lo[1] = std::min(lo[1], y[i]);
      hi[1] = std::max(hi[1], y[i]);
    }
  const double width = reach / 2.;
  int bins[2];
  for (int d = 0; d < 2; ++d)
    bins[d] = std::clamp(int((hi[d] - lo[d]) / width) + 1, 1, 256);
  const std::size_t bin_count = std::size_t(bins[0]) * std::size_t(bins[1]);
  std::vector<std::uint32_t> start(bin_count + 1, 0), bin_of(n);
  std::vector<std::uint16_t> order(n);
  const auto bin_index = [&](double value, int d) {
    return std::clamp(int((value - lo[d]) / width), 0, bins[d] - 1);
  };
  for (std::uint32_t i = 0; i < n; ++i)
    {
      bin_of[i] = bin_index(y[i], 1) * bins[0] + bin_index(x[i], 0);
      ++start[bin_of[i] + 1];
    }
  for (std::size_t b = 1; b < start.size(); ++b)
    start[b] += start[b - 1];
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t i = 0; i < n; ++i)
    order[next[bin_of[i]]++] = std::uint16_t(i);

  cell.neighbours.clear();
  cell.first_neighbour.assign(1, 0);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      const int bx = bin_index(x[i], 0), by = bin_index(y[i], 1);
      for (int cy = std::max(by - 2, 0); cy <= std::min(by + 2, bins[1] - 1); ++cy)
        {
          const std::uint32_t from = start[cy * bins[0] + std::max(bx - 2, 0)];
          const std::uint32_t to = start[cy * bins[0] + std::min(bx + 2, bins[0] - 1) + 1];
          for (std::uint32_t k = from; k < to; ++k)
            {
              const std::uint32_t j = order[k];
              const double dx = x[j] - x[i], dy = y[j] - y[i];
              if (j != i && dx * dx + dy * dy < reach2)
                cell.neighbours.push_back(std::uint16_t(j));
            }
        }
      while (cell.neighbours.size() % sph::list_padding != 0)
        cell.neighbours.push_back(std::uint16_t(n));
      cell.first_neighbour.push_back(std::uint32_t(cell.neighbours.size()));
    }

  cell.arcs.clear();
  cell.first_arc.assign(1, 0);
  cell.chunks = 0;
  std::vector<double> mx(nw), my(nw), limit(nw);
  for (std::uint32_t k = 0; k < nw; ++k)
    {
      const std::uint32_t b = k + 1 < nw ? k + 1 : 0;
      mx[k] = 0.5 * (wx[k] + wx[b]);
      my[k] = 0.5 * (wy[k] + wy[b]);
      const double r = reach + 0.5 * std::hypot(wx[b] - wx[k], wy[b] - wy[k]);
      limit[k] = r * r;
    }
  std::vector<unsigned char> near(nw);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      unsigned int count = 0;
      for (std::uint32_t k = 0; k < nw; ++k)
        {
          const double dx = mx[k] - x[i], dy = my[k] - y[i];
          near[k] = dx * dx + dy * dy < limit[k];
          count += near[k];
        }
      std::uint32_t chunks = 0;
      const auto add_arc = [&](std::uint32_t first, std::uint32_t length) {
        cell.arcs.push_back({std::uint16_t(first), std::uint16_t(length)});
        chunks += (length + sph::list_padding - 1) / sph::list_padding * 2;
      };
      if (count == nw)
        add_arc(0, nw);
      else if (count > 0)
        {
          std::uint32_t origin = 0;
          while (near[origin])
            ++origin;
          for (std::uint32_t s = 0; s < nw;)
            {
              const std::uint32_t k = (origin + s) % nw;
              if (!near[k])
                {
                  ++s;
                  continue;
                }
              std::uint32_t length = 0;
              while (s < nw && near[(origin + s) % nw])
                {
                  ++s;
                  ++length;
                }
              add_arc(k, length);
            }
        }
      cell.chunks = std::max(cell.chunks, chunks);
      cell.first_arc.push_back(std::uint32_t(cell.arcs.size()));
    }
  ++cell.builds;
}

void SphFluid::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group)
{
  const Group &g = particles.groups[group];
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  if (n == 0)
    return;
  Cell &cell = cells[group];
  if (moved_too_far(particles, g, cell))
    {
      for (int d = 0; d < 2; ++d)
        cell.built_at[d].assign(particles.x[d].begin() + g.begin, particles.x[d].begin() + g.end);
      build(g, cell);
    }

  thread_local Scratch scratch;
  const std::size_t ring = round_up(2 * nw + sph::list_padding + 1), rows = std::size_t(n + 1) * sph::row_doubles;
  const std::size_t half = std::size_t(4) * sph::list_padding * sph::block * (cell.chunks + 1);
  double *memory = scratch.get(rows + 2 * half + 8 * ring);
  double *wall = memory + rows + 2 * half;

  sph::CellView view;
  view.n = n;
  view.n_wall = nw;
  view.rows = memory;
  view.scratch = memory + rows;
  view.scratch_half = std::uint32_t(half);
  view.support = parameters.support;
  view.mass = mass[group];
  view.depth = parameters.depth;
  view.viscosity = parameters.viscosity;
  view.eos = &eos_pressure;
  view.eos_data = &eos;
  view.neighbours = cell.neighbours.data();
  view.first_neighbour = cell.first_neighbour.data();
  view.arcs = cell.arcs.data();
  view.first_arc = cell.first_arc.data();
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

  const sph::Sweeps &sweeps = sph::sweeps();
  sweeps.density(view);
  sweeps.force(view);
  cell.crossed = view.crossed;

  for (int d = 0; d < 2; ++d)
    {
      double *f = particles.f[d].data() + g.begin;
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
  double total = 0.;
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
  if (parameters.viscosity > 0.)
    {
      // Wendland C2, continuous limit: sum V |W'|/r = 14/R^2; the central pair drag takes half of
      // it in one direction, chi mu/2 = 8 mu, and the highest mode moves neighbours oppositely.
      bound.fluid.drag = 2. * 8. * 7. * parameters.viscosity / (rho * R * R);
      // No slip drags the wall's light nodes: mu z0 l over the least gap that counts, half a
      // spacing (doc/validation.md has the measured limit beside this bound).
      for (const Group &g : particles.groups)
        {
          double heaviest = 0.; // inverse mass of the lightest node
          for (std::uint32_t i = g.begin; i < g.fluid; ++i)
            heaviest = std::max(heaviest, particles.inverse_mass[i]);
          const std::uint32_t n = g.wall_count();
          double length = 0.;
          for (std::uint32_t k = 0; k < n; ++k)
            length += (particles.position(g.begin + (k + 1) % n) - particles.position(g.begin + k)).norm() / n;
          bound.wall.drag = std::max(bound.wall.drag, parameters.viscosity * parameters.depth * length * heaviest
                                                        / (0.5 * R / 2.6));
          break; // all cells start as copies
        }
    }
  return bound;
}

void SphFluid::forget_lists()
{
  for (Cell &cell : cells)
    for (auto &positions : cell.built_at)
      positions.clear();
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
      for (std::uint32_t i = 0; i + 1 < cell.first_neighbour.size(); ++i)
        for (std::uint32_t k = cell.first_neighbour[i]; k < cell.first_neighbour[i + 1]; ++k)
          if (cell.neighbours[k] < g.fluid_count())
            pairs += (particles.position(g.fluid + cell.neighbours[k]) - particles.position(g.fluid + i)).norm()
                     < parameters.support;
    }
  return n > 0 ? double(pairs) / double(n) : 0.;
}

std::size_t SphFluid::memory_bytes() const
{
  std::size_t bytes = 0;
  for (const Cell &cell : cells)
    bytes += cell.neighbours.capacity() * 2 + (cell.first_neighbour.capacity() + cell.first_arc.capacity()) * 4
             + cell.arcs.capacity() * sizeof(sph::Arc)
             + (cell.built_at[0].capacity() + cell.built_at[1].capacity()) * 8;
  return bytes;
}

void SphFluid::save(std::ostream &out, const Particles<2> &) const
{
  write_binary(out, mass);
  for (const Cell &cell : cells)
    for (int d = 0; d < 2; ++d)
      write_binary(out, cell.built_at[d]);
}

void SphFluid::load(std::istream &in, Particles<2> &particles)
{
  read_binary(in, mass);
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      Cell &cell = cells[group];
      for (int d = 0; d < 2; ++d)
        read_binary(in, cell.built_at[d]);
      set_particle_mass(particles, group, mass[group]);
      if (!cell.built_at[0].empty() && particles.groups[group].fluid_count() > 0)
        build(particles.groups[group], cell);
    }
}
} // namespace turgor
