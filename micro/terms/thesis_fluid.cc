#include "micro/terms/thesis_fluid.h"

#include "micro/engine/binary.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
ThesisFluid::ThesisFluid(const ThesisFluidParameters &parameters_, const EquationOfState &eos_,
                         const LennardJonesWall &wall, std::vector<double> mass_)
  : parameters(parameters_)
  , eos(eos_)
  , wall_law(wall)
  , kernel(parameters_.support)
  , mass(std::move(mass_))
{}

std::string ThesisFluid::name() const
{
  const std::string viscous = parameters.viscosity <= 0.                   ? "" :
                              parameters.law == ViscosityLaw::monaghan ? "+monaghan_viscosity" :
                                                                             "+morris_viscosity";
  return "thesis_fluid+lennard_jones_wall" + viscous;
}

void ThesisFluid::declare(Particles<2> &particles)
{
  particles.declare("density");
  particles.declare("pressure");
  cells.assign(particles.groups.size(), Cell());
  std::vector<double> &rho = particles.field("density");
  for (const Group &g : particles.groups)
    std::fill(rho.begin() + g.fluid, rho.begin() + g.end, parameters.initial_density);
}

void ThesisFluid::set_particle_mass(Particles<2> &particles, const std::size_t group, const double value)
{
  const Group &g = particles.groups[group];
  std::vector<double> &rho = particles.field("density");
  const double ratio = value / mass[group];
  for (std::uint32_t i = g.fluid; i < g.end; ++i)
    {
      rho[i] *= ratio;
      particles.inverse_mass[i] = 1. / value;
    }
  mass[group] = value;
}

void ThesisFluid::update_lists(const Particles<2> &particles, const std::size_t group)
{
  const Group &g = particles.groups[group];
  Cell &cell = cells[group];
  if (!cell.built_at.stale(particles, g, parameters.skin))
    return;
  cell.built_at.take(particles.x, g);
  build(g, cell);
}

void ThesisFluid::build(const Group &g, Cell &cell) const
{
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  const double *wx = cell.built_at[0], *wy = cell.built_at[1], *x = wx + nw, *y = wy + nw;
  ++cell.builds;
  cell.fluid.clear();
  cell.wall.clear();
  cell.first_fluid.assign(n + 1, 0);
  cell.first_wall.assign(n + 1, 0);
  cell.crossed = 0;
  double lo[2] = {HUGE_VAL, HUGE_VAL}, hi[2] = {-HUGE_VAL, -HUGE_VAL}, check = 0.;
  for (std::uint32_t k = 0; k < nw + n; ++k)
    {
      lo[0] = std::min(lo[0], wx[k]);
      hi[0] = std::max(hi[0], wx[k]);
      lo[1] = std::min(lo[1], wy[k]);
      hi[1] = std::max(hi[1], wy[k]);
      check += wx[k] + wy[k];
    }
  if (n == 0 || !std::isfinite(check))
    return; // no pairs: the scene sees the positions themselves and says that it diverged

  // Fluid in bins as wide as the larger reach.
  const double reach = parameters.support + parameters.skin, wall_reach = wall_law.range() + parameters.skin;
  const double width = std::max(reach, wall_reach);
  const int nx = std::clamp(int(std::min((hi[0] - lo[0]) / width, 1e6)) + 1, 1, 512);
  const int ny = std::clamp(int(std::min((hi[1] - lo[1]) / width, 1e6)) + 1, 1, 512);
  const auto bin = [&](const double value, const int d) {
    return std::clamp(int(std::min((value - lo[d]) / width, 1e6)), 0, (d == 0 ? nx : ny) - 1);
  };
  const auto sorted = [&](const double *px, const double *py, const std::uint32_t count) {
    std::vector<std::vector<std::uint32_t>> bins(std::size_t(nx) * ny);
    for (std::uint32_t k = 0; k < count; ++k)
      bins[std::size_t(bin(py[k], 1)) * nx + bin(px[k], 0)].push_back(k);
    return bins;
  };
  const auto fluid_bins = sorted(x, y, n), wall_bins = sorted(wx, wy, nw);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      const int bx = bin(x[i], 0), by = bin(y[i], 1);
      for (int cy = std::max(by - 1, 0); cy <= std::min(by + 1, ny - 1); ++cy)
        for (int cx = std::max(bx - 1, 0); cx <= std::min(bx + 1, nx - 1); ++cx)
          {
            const std::size_t b = std::size_t(cy) * nx + cx;
            for (const std::uint32_t j : fluid_bins[b])
              if (j > i && std::hypot(x[j] - x[i], y[j] - y[i]) < reach)
                cell.fluid.push_back(j);
            for (const std::uint32_t k : wall_bins[b])
              if (std::hypot(wx[k] - x[i], wy[k] - y[i]) < wall_reach)
                cell.wall.push_back(k);
          }
      cell.first_fluid[i + 1] = std::uint32_t(cell.fluid.size());
      cell.first_wall[i + 1] = std::uint32_t(cell.wall.size());
      // Even number of walls on a ray to the right: outside.
      bool inside = false;
      for (std::uint32_t k = 0; k < nw; ++k)
        {
          const std::uint32_t b = k + 1 < nw ? k + 1 : 0;
          if ((wy[k] > y[i]) != (wy[b] > y[i])
              && x[i] < wx[k] + (y[i] - wy[k]) / (wy[b] - wy[k]) * (wx[b] - wx[k]))
            inside = !inside;
        }
      cell.crossed += !inside;
    }
}

/// visit(i, j, dx, dy, W'/r / z_0) for each pair once; i, j count the fluid of the group; d = x_j - x_i.
template <class Visit>
void ThesisFluid::for_fluid_pairs(const Group &g, const Cell &cell, const double *x, const double *y,
                                  Visit &&visit) const
{
  const double reach2 = parameters.support * parameters.support, inverse_depth = 1. / parameters.depth;
  for (std::uint32_t i = 0; i < g.fluid_count(); ++i)
    for (std::uint32_t k = cell.first_fluid[i]; k < cell.first_fluid[i + 1]; ++k)
      {
        const std::uint32_t j = cell.fluid[k];
        const double dx = x[j] - x[i], dy = y[j] - y[i], r2 = dx * dx + dy * dy;
        if (r2 < reach2)
          visit(i, j, dx, dy, kernel.slope_over_r(std::sqrt(r2)) * inverse_depth);
      }
}

void ThesisFluid::drift(Particles<2> &particles, const std::size_t group, const double dt)
{
  update_lists(particles, group);
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.fluid_count();
  thread_local std::vector<double> middle[2], change;
  change.assign(n, 0.);
  for (int d = 0; d < 2; ++d)
    {
      middle[d].resize(n);
      for (std::uint32_t i = 0; i < n; ++i)
        middle[d][i] = particles.x[d][g.fluid + i] - 0.5 * dt * particles.v[d][g.fluid + i];
    }
  const double *vx = particles.v[0].data() + g.fluid, *vy = particles.v[1].data() + g.fluid;
  for_fluid_pairs(g, cells[group], middle[0].data(), middle[1].data(),
                  [&](std::uint32_t i, std::uint32_t j, double dx, double dy, double w) {
                    const double rate = w * ((vx[j] - vx[i]) * dx + (vy[j] - vy[i]) * dy);
                    change[i] += rate;
                    change[j] += rate;
                  });
  double *rho = particles.field("density").data() + g.fluid;
  for (std::uint32_t i = 0; i < n; ++i)
    rho[i] += dt * mass[group] * change[i];
}

void ThesisFluid::jumped(Particles<2> &particles, const Particles<2>::Components &before)
{
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      const Group &g = particles.groups[group];
      Cell &cell = cells[group];
      double *rho = particles.field("density").data() + g.fluid;
      for (const auto *positions : {&before, &static_cast<const Particles<2>::Components &>(particles.x)})
        {
          cell.built_at.take(*positions, g);
          build(g, cell);
          const double *x = (*positions)[0].data() + g.fluid, *y = (*positions)[1].data() + g.fluid;
          const double share = (positions == &before ? -1. : 1.) * mass[group] / parameters.depth;
          for_fluid_pairs(g, cell, x, y, [&](std::uint32_t i, std::uint32_t j, double dx, double dy, double) {
            const double change = share * kernel.value(std::hypot(dx, dy));
            rho[i] += change;
            rho[j] += change;
          });
        }
    }
}

void ThesisFluid::add_forces(Particles<2> &particles, const Box<2> &, const std::size_t group)
{
  update_lists(particles, group);
  const Group &g = particles.groups[group];
  const Cell &cell = cells[group];
  const std::uint32_t n = g.fluid_count();
  const double *rho = particles.field("density").data() + g.fluid;
  double *pressure = particles.field("pressure").data() + g.fluid;
  thread_local std::vector<double> share;
  share.resize(n);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      pressure[i] = eos.pressure(rho[i]);
      share[i] = pressure[i] / (rho[i] * rho[i]);
    }
  const double *x = particles.x[0].data() + g.fluid, *y = particles.x[1].data() + g.fluid;
  const double *vx = particles.v[0].data() + g.fluid, *vy = particles.v[1].data() + g.fluid;
  double *fx = particles.f[0].data() + g.fluid, *fy = particles.f[1].data() + g.fluid;
  const double m2 = mass[group] * mass[group];
  const bool viscous = parameters.viscosity > 0., central = parameters.law == ViscosityLaw::monaghan;
  for_fluid_pairs(g, cell, x, y, [&](std::uint32_t i, std::uint32_t j, double dx, double dy, double w) {
    const double p = m2 * (share[i] + share[j]) * w;
    double pair_x = p * dx, pair_y = p * dy; // on i; w < 0: away from j
    if (viscous)
      {
        const double ux = vx[j] - vx[i], uy = vy[j] - vy[i], c = -parameters.viscosity * m2 / (rho[i] * rho[j]) * w;
        if (central)
          {
            const double along = 8. * c * (ux * dx + uy * dy) / (dx * dx + dy * dy);
            pair_x += along * dx;
            pair_y += along * dy;
          }
        else
          {
            pair_x += 2. * c * ux;
            pair_y += 2. * c * uy;
          }
      }
    fx[i] += pair_x;
    fy[i] += pair_y;
    fx[j] -= pair_x;
    fy[j] -= pair_y;
  });

  const double *wx = particles.x[0].data() + g.begin, *wy = particles.x[1].data() + g.begin;
  double *wall_fx = particles.f[0].data() + g.begin, *wall_fy = particles.f[1].data() + g.begin;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t l = cell.first_wall[i]; l < cell.first_wall[i + 1]; ++l)
      {
        const std::uint32_t k = cell.wall[l];
        const double dx = x[i] - wx[k], dy = y[i] - wy[k];
        const double f = wall_law.force_over_r(std::sqrt(dx * dx + dy * dy));
        fx[i] += f * dx;
        fy[i] += f * dy;
        wall_fx[k] -= f * dx;
        wall_fy[k] -= f * dy;
      }
}

double ThesisFluid::energy(const Particles<2> &particles, const Box<2> &, const std::size_t group) const
{
  const Group &g = particles.groups[group];
  const Cell &cell = cells[group];
  const std::vector<double> &rho = particles.field("density");
  double total = 0.;
  for (std::uint32_t i = g.fluid; i < g.end; ++i)
    total += mass[group] * eos.energy(rho[i]);
  for (std::uint32_t i = 0; i + 1 < cell.first_wall.size(); ++i)
    for (std::uint32_t l = cell.first_wall[i]; l < cell.first_wall[i + 1]; ++l)
      total += wall_law.energy((particles.position(g.fluid + i) - particles.position(g.begin + cell.wall[l])).norm());
  return total;
}

Rates ThesisFluid::rates(const Particles<2> &particles) const
{
  Rates bound;
  const double R = parameters.support, rho = eos.reference_density(), c = eos.sound_speed(1.05 * rho);
  // As of the corrected sums (sph_fluid.cc): wave number about 6.5 / R.
  bound.fluid.frequency_squared = 6.5 * 6.5 * c * c / (R * R);
  if (parameters.viscosity > 0.)
    bound.fluid.drag = (parameters.law == ViscosityLaw::monaghan ? 112. : 56.) * parameters.viscosity / (rho * R * R);
  // The repulsion has no upper bound; the step is for up to five times the force that holds turgor, on
  // one pair, both sides of it moving.
  const double stiffness = 2. * wall_law.stiffness_at(5. * parameters.holding_force);
  for (const Group &g : particles.groups)
    {
      double lightest[2] = {0., 0.}; // inverse masses: wall, fluid
      for (std::uint32_t i = g.begin; i < g.end; ++i)
        lightest[i >= g.fluid] = std::max(lightest[i >= g.fluid], particles.inverse_mass[i]);
      bound.wall.frequency_squared += stiffness * lightest[0];
      bound.fluid.frequency_squared += stiffness * lightest[1];
      break; // all cells start as copies
    }
  return bound;
}

void ThesisFluid::forget_lists()
{
  for (Cell &cell : cells)
    cell.built_at.forget();
}

std::size_t ThesisFluid::crossed() const
{
  std::size_t total = 0;
  for (const Cell &cell : cells)
    total += cell.crossed;
  return total;
}

std::size_t ThesisFluid::list_builds() const
{
  std::size_t total = 0;
  for (const Cell &cell : cells)
    total += cell.builds;
  return total;
}

double ThesisFluid::mean_neighbours(const Particles<2> &particles) const
{
  std::size_t pairs = 0, n = 0;
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      const Group &g = particles.groups[group];
      n += g.fluid_count();
      if (!cells[group].first_fluid.empty())
        for_fluid_pairs(g, cells[group], particles.x[0].data() + g.fluid, particles.x[1].data() + g.fluid,
                        [&](std::uint32_t, std::uint32_t, double, double, double) { pairs += 2; });
    }
  return n > 0 ? double(pairs) / double(n) : 0.;
}

std::size_t ThesisFluid::memory_bytes() const
{
  std::size_t bytes = 0;
  for (const Cell &cell : cells)
    bytes += 4 * (cell.fluid.capacity() + cell.wall.capacity() + cell.first_fluid.capacity() + cell.first_wall.capacity())
             + cell.built_at.memory_bytes();
  return bytes;
}

void ThesisFluid::save(std::ostream &out, const Particles<2> &particles) const
{
  write_binary(out, mass);
  write_binary(out, particles.field("density"));
  for (const Cell &cell : cells)
    cell.built_at.save(out);
}

void ThesisFluid::load(std::istream &in, Particles<2> &particles)
{
  read_binary(in, mass);
  std::vector<double> &rho = particles.field("density");
  read_binary(in, rho);
  if (rho.size() != particles.size() || mass.size() != cells.size())
    throw std::runtime_error("the checkpoint's densities do not belong to this scene");
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      Cell &cell = cells[group];
      const Group &g = particles.groups[group];
      for (std::uint32_t i = g.fluid; i < g.end; ++i)
        particles.inverse_mass[i] = 1. / mass[group];
      cell.built_at.load(in);
      if (cell.built_at.size() == g.end - g.begin)
        build(g, cell);
    }
}
} // namespace turgor
