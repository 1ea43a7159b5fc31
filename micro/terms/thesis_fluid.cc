#include "micro/terms/thesis_fluid.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace turgor
{
template <int dim>
ThesisFluid<dim>::ThesisFluid(const ThesisFluidParameters &parameters_, const EquationOfState &eos_,
                              const LennardJonesWall &wall, std::vector<double> mass_,
                              std::vector<std::array<std::uint16_t, 3>> faces_)
  : parameters(parameters_)
  , eos(eos_)
  , wall_law(wall)
  , kernel(parameters_.support)
  , mass(std::move(mass_))
  , faces(std::move(faces_))
{}

template <int dim>
std::string ThesisFluid<dim>::name() const
{
  const std::string viscous = parameters.viscosity <= 0.                   ? "" :
                              parameters.law == ViscosityLaw::monaghan ? "+monaghan_viscosity" :
                                                                             "+morris_viscosity";
  return "thesis_fluid+lennard_jones_wall" + viscous;
}

template <int dim>
void ThesisFluid<dim>::declare(Particles<dim> &particles)
{
  particles.declare("density");
  particles.declare("pressure");
  cells.assign(particles.groups.size(), Cell());
  std::vector<double> &rho = particles.field("density");
  for (const Group &g : particles.groups)
    std::fill(rho.begin() + g.fluid, rho.begin() + g.end, parameters.initial_density);
}

template <int dim>
void ThesisFluid<dim>::set_particle_mass(Particles<dim> &particles, const std::size_t group, const double value)
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

template <int dim>
void ThesisFluid<dim>::update_lists(const Particles<dim> &particles, const std::size_t group)
{
  const Group &g = particles.groups[group];
  Cell &cell = cells[group];
  if (!cell.built_at.stale(particles, g, parameters.skin))
    return;
  cell.built_at.take(particles.x, g);
  build(g, cell);
}

template <int dim>
void ThesisFluid<dim>::build(const Group &g, Cell &cell) const
{
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  ++cell.builds;
  cell.fluid.clear();
  cell.wall.clear();
  cell.first_fluid.assign(n + 1, 0);
  cell.first_wall.assign(n + 1, 0);
  cell.crossed = 0;
  if (n == 0 || !cell.built_at.finite())
    return; // no pairs: the scene sees the positions themselves and says that it diverged

  // Fluid and nodes in bins as wide as the larger reach.
  const double reach = parameters.support + parameters.skin, wall_reach = wall_law.range() + parameters.skin;
  const double width = std::max(reach, wall_reach);
  std::array<const double *, dim> wall, fluid;
  std::array<double, dim> low;
  std::array<int, dim> bins;
  std::size_t all = 1;
  for (int d = 0; d < dim; ++d)
    {
      wall[d] = cell.built_at[d];
      fluid[d] = wall[d] + nw;
      const auto [least, most] = std::minmax_element(wall[d], wall[d] + nw + n);
      low[d] = *least;
      bins[d] = std::clamp(int(std::min((*most - *least) / width, 1e6)) + 1, 1, dim == 2 ? 512 : 64);
      all *= std::size_t(bins[d]);
    }
  const auto bin = [&](const std::array<const double *, dim> &x, const std::uint32_t k, const int d) {
    return std::clamp(int(std::min((x[d][k] - low[d]) / width, 1e6)), 0, bins[d] - 1);
  };
  const auto sorted = [&](const std::array<const double *, dim> &x, const std::uint32_t count) {
    std::vector<std::vector<std::uint32_t>> result(all);
    for (std::uint32_t k = 0; k < count; ++k)
      {
        std::size_t at = 0;
        for (int d = dim - 1; d >= 0; --d)
          at = at * std::size_t(bins[d]) + std::size_t(bin(x, k, d));
        result[at].push_back(k);
      }
    return result;
  };
  const auto distance = [&](const std::array<const double *, dim> &x, const std::uint32_t k, const std::uint32_t i) {
    double r2 = 0.;
    for (int d = 0; d < dim; ++d)
      r2 += (x[d][k] - fluid[d][i]) * (x[d][k] - fluid[d][i]);
    return std::sqrt(r2);
  };
  const auto fluid_bins = sorted(fluid, n), wall_bins = sorted(wall, nw);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      std::array<int, dim> from, to;
      for (int d = 0; d < dim; ++d)
        {
          const int own = bin(fluid, i, d);
          from[d] = std::max(own - 1, 0);
          to[d] = std::min(own + 1, bins[d] - 1);
        }
      const auto visit = [&](const std::size_t row) {
        for (int c = from[0]; c <= to[0]; ++c)
          {
            const std::size_t at = row * std::size_t(bins[0]) + std::size_t(c);
            for (const std::uint32_t j : fluid_bins[at])
              if (j > i && distance(fluid, j, i) < reach)
                cell.fluid.push_back(j);
            for (const std::uint32_t k : wall_bins[at])
              if (distance(wall, k, i) < wall_reach)
                cell.wall.push_back(k);
          }
      };
      if constexpr (dim == 2)
        for (int cy = from[1]; cy <= to[1]; ++cy)
          visit(std::size_t(cy));
      else
        for (int cz = from[2]; cz <= to[2]; ++cz)
          for (int cy = from[1]; cy <= to[1]; ++cy)
            visit(std::size_t(cz) * std::size_t(bins[1]) + std::size_t(cy));
      cell.first_fluid[i + 1] = std::uint32_t(cell.fluid.size());
      cell.first_wall[i + 1] = std::uint32_t(cell.wall.size());
    }
  cell.crossed = count_outside(g, cell);
}

/// A ray in x from a particle inside crosses the wall an odd number of times.
template <int dim>
std::size_t ThesisFluid<dim>::count_outside(const Group &g, const Cell &cell) const
{
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  const ListOrigin<dim> &at = cell.built_at;
  std::vector<unsigned char> inside(n, 0);
  if constexpr (dim == 2)
    for (std::uint32_t i = 0; i < n; ++i)
      {
        const double x = at[0][nw + i], y = at[1][nw + i];
        for (std::uint32_t k = 0; k < nw; ++k)
          {
            const std::uint32_t b = k + 1 < nw ? k + 1 : 0;
            if ((at[1][k] > y) != (at[1][b] > y)
                && x < at[0][k] + (y - at[1][k]) / (at[1][b] - at[1][k]) * (at[0][b] - at[0][k]))
              inside[i] ^= 1;
          }
      }
  else
    {
      if (faces.empty())
        return 0;
      std::vector<std::uint32_t> by_height(n);
      std::iota(by_height.begin(), by_height.end(), 0u);
      const double *z = at[2] + nw;
      std::sort(by_height.begin(), by_height.end(), [&](std::uint32_t a, std::uint32_t b) { return z[a] < z[b]; });
      for (const auto &[a, b, c] : faces)
        {
          const double low = std::min({at[2][a], at[2][b], at[2][c]}), high = std::max({at[2][a], at[2][b], at[2][c]});
          const double u[2] = {at[1][b] - at[1][a], at[2][b] - at[2][a]}, v[2] = {at[1][c] - at[1][a], at[2][c] - at[2][a]};
          const double area = u[0] * v[1] - u[1] * v[0];
          auto i = std::lower_bound(by_height.begin(), by_height.end(), low,
                                    [&](std::uint32_t k, double value) { return z[k] < value; });
          for (; i != by_height.end() && z[*i] <= high; ++i)
            {
              const double y = at[1][nw + *i] - at[1][a], h = z[*i] - at[2][a];
              const double s = (y * v[1] - h * v[0]) / area, t = (u[0] * h - u[1] * y) / area;
              if (s >= 0. && t >= 0. && s + t <= 1.
                  && at[0][nw + *i] < at[0][a] + s * (at[0][b] - at[0][a]) + t * (at[0][c] - at[0][a]))
                inside[*i] ^= 1;
            }
        }
    }
  return std::size_t(std::count(inside.begin(), inside.end(), 0));
}

/// visit(i, j, r, r.r, W'/r / z_0) for each pair once; i, j count the fluid of the group; r = x_j - x_i.
template <int dim>
template <class Visit>
void ThesisFluid<dim>::for_fluid_pairs(const Group &g, const Cell &cell, const std::array<const double *, dim> &x,
                                       Visit &&visit) const
{
  const double reach2 = parameters.support * parameters.support, inverse_depth = 1. / parameters.depth;
  for (std::uint32_t i = 0; i < g.fluid_count(); ++i)
    for (std::uint32_t k = cell.first_fluid[i]; k < cell.first_fluid[i + 1]; ++k)
      {
        const std::uint32_t j = cell.fluid[k];
        std::array<double, dim> r;
        double r2 = 0.;
        for (int d = 0; d < dim; ++d)
          {
            r[d] = x[d][j] - x[d][i];
            r2 += r[d] * r[d];
          }
        if (r2 < reach2)
          visit(i, j, r, r2, kernel.slope_over_r(std::sqrt(r2)) * inverse_depth);
      }
}

template <int dim>
void ThesisFluid<dim>::drift(Particles<dim> &particles, const std::size_t group, const double dt)
{
  update_lists(particles, group);
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.fluid_count();
  thread_local std::vector<double> middle[dim], change;
  change.assign(n, 0.);
  for (int d = 0; d < dim; ++d)
    {
      middle[d].resize(n);
      for (std::uint32_t i = 0; i < n; ++i)
        middle[d][i] = particles.x[d][g.fluid + i] - 0.5 * dt * particles.v[d][g.fluid + i];
    }
  std::array<const double *, dim> x, v;
  for (int d = 0; d < dim; ++d)
    {
      x[d] = middle[d].data();
      v[d] = particles.v[d].data() + g.fluid;
    }
  for_fluid_pairs(g, cells[group], x, [&](std::uint32_t i, std::uint32_t j, const auto &r, double, double w) {
    double approach = 0.;
    for (int d = 0; d < dim; ++d)
      approach += (v[d][j] - v[d][i]) * r[d];
    const double rate = w * approach;
    change[i] += rate;
    change[j] += rate;
  });
  double *rho = particles.field("density").data() + g.fluid;
  for (std::uint32_t i = 0; i < n; ++i)
    rho[i] += dt * mass[group] * change[i];
}

template <int dim>
void ThesisFluid<dim>::jumped(Particles<dim> &particles, const typename Particles<dim>::Components &before)
{
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      const Group &g = particles.groups[group];
      Cell &cell = cells[group];
      double *rho = particles.field("density").data() + g.fluid;
      for (const auto *positions : {&before, &static_cast<const typename Particles<dim>::Components &>(particles.x)})
        {
          cell.built_at.take(*positions, g);
          build(g, cell);
          std::array<const double *, dim> x;
          for (int d = 0; d < dim; ++d)
            x[d] = (*positions)[d].data() + g.fluid;
          const double share = (positions == &before ? -1. : 1.) * mass[group] / parameters.depth;
          for_fluid_pairs(g, cell, x, [&](std::uint32_t i, std::uint32_t j, const auto &, double r2, double) {
            const double change = share * kernel.value(std::sqrt(r2));
            rho[i] += change;
            rho[j] += change;
          });
        }
    }
}

template <int dim>
void ThesisFluid<dim>::add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group)
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
  std::array<const double *, dim> x, v, wall_x;
  std::array<double *, dim> f, wall_f;
  for (int d = 0; d < dim; ++d)
    {
      wall_x[d] = particles.x[d].data() + g.begin;
      wall_f[d] = particles.f[d].data() + g.begin;
      x[d] = particles.x[d].data() + g.fluid;
      v[d] = particles.v[d].data() + g.fluid;
      f[d] = particles.f[d].data() + g.fluid;
    }
  const double m2 = mass[group] * mass[group];
  const bool viscous = parameters.viscosity > 0., central = parameters.law == ViscosityLaw::monaghan;
  for_fluid_pairs(g, cell, x, [&](std::uint32_t i, std::uint32_t j, const auto &r, double r2, double w) {
    const double p = m2 * (share[i] + share[j]) * w;
    std::array<double, dim> pair; // on i; w < 0: away from j
    for (int d = 0; d < dim; ++d)
      pair[d] = p * r[d];
    if (viscous)
      {
        const double c = -parameters.viscosity * m2 / (rho[i] * rho[j]) * w;
        double approach = 0.;
        for (int d = 0; d < dim; ++d)
          approach += (v[d][j] - v[d][i]) * r[d];
        const double along = half_chi * c * approach / r2;
        for (int d = 0; d < dim; ++d)
          pair[d] += central ? along * r[d] : 2. * c * (v[d][j] - v[d][i]);
      }
    for (int d = 0; d < dim; ++d)
      {
        f[d][i] += pair[d];
        f[d][j] -= pair[d];
      }
  });

  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t l = cell.first_wall[i]; l < cell.first_wall[i + 1]; ++l)
      {
        const std::uint32_t k = cell.wall[l];
        std::array<double, dim> r;
        double r2 = 0.;
        for (int d = 0; d < dim; ++d)
          {
            r[d] = x[d][i] - wall_x[d][k];
            r2 += r[d] * r[d];
          }
        const double push = wall_law.force_over_r(std::sqrt(r2));
        for (int d = 0; d < dim; ++d)
          {
            f[d][i] += push * r[d];
            wall_f[d][k] -= push * r[d];
          }
      }
}

template <int dim>
double ThesisFluid<dim>::energy(const Particles<dim> &particles, const Box<dim> &, const std::size_t group) const
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

template <int dim>
Rates ThesisFluid<dim>::rates(const Particles<dim> &particles) const
{
  Rates bound;
  const double R = parameters.support, rho = eos.reference_density(), c = eos.sound_speed(1.05 * rho);
  // As of the corrected sums (sph_fluid.cc): wave number about 6.5 / R.
  bound.fluid.frequency_squared = 6.5 * 6.5 * c * c / (R * R);
  if (parameters.viscosity > 0.)
    // sum V |W'|/r = 14/R^2 in the continuous limit, in 2D and 3D; the central drag takes 1/dim of it in one direction,
    // and the highest mode moves neighbours oppositely
    bound.fluid.drag = 2. * 14. * (parameters.law == ViscosityLaw::monaghan ? half_chi / dim : 2.) * parameters.viscosity
                       / (rho * R * R);
  // The repulsion has no upper bound; the step is for up to five times the force that holds turgor, on
  // one pair, both sides of it moving.
  const double stiffness = 2. * wall_law.stiffness_at(5. * parameters.holding_force);
  double lightest[2] = {0., 0.}; // inverse masses: wall, fluid
  for (const Group &g : particles.groups)
    for (std::uint32_t i = g.begin; i < g.end; ++i)
      lightest[i >= g.fluid] = std::max(lightest[i >= g.fluid], particles.inverse_mass[i]);
  bound.wall.frequency_squared += stiffness * lightest[0];
  bound.fluid.frequency_squared += stiffness * lightest[1];
  return bound;
}

template <int dim>
void ThesisFluid<dim>::forget_lists()
{
  for (Cell &cell : cells)
    cell.built_at.forget();
}

template <int dim>
std::size_t ThesisFluid<dim>::crossed() const
{
  std::size_t total = 0;
  for (const Cell &cell : cells)
    total += cell.crossed;
  return total;
}

template <int dim>
std::size_t ThesisFluid<dim>::list_builds() const
{
  std::size_t total = 0;
  for (const Cell &cell : cells)
    total += cell.builds;
  return total;
}

template <int dim>
double ThesisFluid<dim>::mean_neighbours(const Particles<dim> &particles) const
{
  std::size_t pairs = 0, n = 0;
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      const Group &g = particles.groups[group];
      n += g.fluid_count();
      std::array<const double *, dim> x;
      for (int d = 0; d < dim; ++d)
        x[d] = particles.x[d].data() + g.fluid;
      if (!cells[group].first_fluid.empty())
        for_fluid_pairs(g, cells[group], x,
                        [&](std::uint32_t, std::uint32_t, const auto &, double, double) { pairs += 2; });
    }
  return n > 0 ? double(pairs) / double(n) : 0.;
}

template <int dim>
std::size_t ThesisFluid<dim>::memory_bytes() const
{
  std::size_t bytes = 0;
  for (const Cell &cell : cells)
    bytes += 4 * (cell.fluid.capacity() + cell.wall.capacity() + cell.first_fluid.capacity() + cell.first_wall.capacity())
             + cell.built_at.memory_bytes();
  return bytes;
}

template <int dim>
void ThesisFluid<dim>::archive(Archive &a, Particles<dim> &particles)
{
  a.section("thesis fluid");
  a.fixed(mass, particles.field("density"));
  for (std::size_t group = 0; group < cells.size(); ++group)
    {
      Cell &cell = cells[group];
      a(cell.built_at);
      if (!a.loading())
        continue;
      const Group &g = particles.groups[group];
      for (std::uint32_t i = g.fluid; i < g.end; ++i)
        particles.inverse_mass[i] = 1. / mass[group];
      if (cell.built_at.size() == g.end - g.begin)
        build(g, cell);
    }
}

template class ThesisFluid<2>;
template class ThesisFluid<3>;
} // namespace turgor
