#include "micro/terms/thesis_fluid.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
template <int dim>
ThesisFluid<dim>::ThesisFluid(const ThesisFluidParameters &parameters_, const EquationOfState &eos_,
                              const LennardJonesWall &wall, std::vector<double> mass_,
                              std::vector<std::array<std::uint16_t, 3>> faces_)
    : parameters(parameters_),
      eos(eos_),
      wall_law(wall),
      kernel(parameters_.support),
      inverse_depth(1. / parameters_.depth),
      mass(std::move(mass_)),
      faces(std::move(faces_)) {}

template <int dim>
std::string ThesisFluid<dim>::name() const {
  const std::string viscous = parameters.viscosity <= 0.                 ? ""
                              : parameters.law == ViscosityLaw::monaghan ? "+monaghan_viscosity"
                                                                         : "+morris_viscosity";
  return "thesis_fluid+lennard_jones_wall" + viscous;
}

template <int dim>
void ThesisFluid<dim>::declare(Particles<dim> &particles) {
  particles.declare("density");
  particles.declare("pressure");
  cells.assign(particles.groups.size(), ThesisPairs<dim>());
  std::vector<double> &rho = particles.field("density");
  for (const Group &g : particles.groups)
    std::fill(rho.begin() + g.fluid, rho.begin() + g.end, parameters.initial_density);
}

template <int dim>
void ThesisFluid<dim>::update_lists(const Particles<dim> &particles, const std::size_t group) {
  const Group &g = particles.groups[group];
  ThesisPairs<dim> &pairs = cells[group];
  if (!pairs.built_at.stale(particles, g, parameters.skin)) return;
  pairs.built_at.take(particles.x, g);
  build(g, pairs);
}

template <int dim>
void ThesisFluid<dim>::build(const Group &g, ThesisPairs<dim> &pairs) const {
  pairs.build(g, parameters.support + parameters.skin, wall_law.range() + parameters.skin, faces);
}

template <int dim>
void ThesisFluid<dim>::add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group) {
  update_lists(particles, group);
  const Group &g = particles.groups[group];
  const ThesisPairs<dim> &cell = cells[group];
  const std::uint32_t n = g.fluid_count();
  const double *rho = particles.field("density").data() + g.fluid;
  double *pressure = particles.field("pressure").data() + g.fluid;
  thread_local std::vector<double> share;
  share.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    pressure[i] = eos.pressure(rho[i]);
    share[i] = pressure[i] / (rho[i] * rho[i]);
  }
  std::array<const double *, dim> x, v;
  std::array<double *, dim> f;
  for (int d = 0; d < dim; ++d) {
    x[d] = particles.x[d].data() + g.fluid;
    v[d] = particles.v[d].data() + g.fluid;
    f[d] = particles.f[d].data() + g.fluid;
  }
  const double m2 = mass[group] * mass[group];
  const bool viscous = parameters.viscosity > 0., central = parameters.law == ViscosityLaw::monaghan;
  cell.for_fluid(x, parameters.support, [&](std::uint32_t i, std::uint32_t j, const auto &r, double r2) {
    const double w = slope_over_r(r2), p = m2 * (share[i] + share[j]) * w;
    std::array<double, dim> pair;  // on i; w < 0: away from j
    for (int d = 0; d < dim; ++d) pair[d] = p * r[d];
    if (viscous) {
      const double c = -parameters.viscosity * m2 / (rho[i] * rho[j]) * w;
      double approach = 0.;
      for (int d = 0; d < dim; ++d) approach += (v[d][j] - v[d][i]) * r[d];
      const double along = half_chi * c * approach / r2;
      for (int d = 0; d < dim; ++d) pair[d] += central ? along * r[d] : 2. * c * (v[d][j] - v[d][i]);
    }
    for (int d = 0; d < dim; ++d) {
      f[d][i] += pair[d];
      f[d][j] -= pair[d];
    }
  });
  push_from_wall(particles, group);
}

/// Eq. 3.7 (corrected).
template <int dim>
void ThesisFluid<dim>::push_from_wall(Particles<dim> &particles, const std::size_t group) const {
  const Group &g = particles.groups[group];
  const ThesisPairs<dim> &cell = cells[group];
  std::array<const double *, dim> x, wall_x;
  std::array<double *, dim> f, wall_f;
  for (int d = 0; d < dim; ++d) {
    wall_x[d] = particles.x[d].data() + g.begin;
    wall_f[d] = particles.f[d].data() + g.begin;
    x[d] = particles.x[d].data() + g.fluid;
    f[d] = particles.f[d].data() + g.fluid;
  }
  for (std::uint32_t i = 0; i < g.fluid_count(); ++i)
    for (std::uint32_t l = cell.first_wall[i]; l < cell.first_wall[i + 1]; ++l) {
      const std::uint32_t k = cell.wall[l];
      std::array<double, dim> r;
      double r2 = 0.;
      for (int d = 0; d < dim; ++d) {
        r[d] = x[d][i] - wall_x[d][k];
        r2 += r[d] * r[d];
      }
      const double push = wall_law.force_over_r(std::sqrt(r2));
      for (int d = 0; d < dim; ++d) {
        f[d][i] += push * r[d];
        wall_f[d][k] -= push * r[d];
      }
    }
}

template <int dim>
double ThesisFluid<dim>::energy(const Particles<dim> &particles, const Box<dim> &,
                                const std::size_t group) const {
  const Group &g = particles.groups[group];
  const ThesisPairs<dim> &cell = cells[group];
  const std::vector<double> &rho = particles.field("density");
  double total = 0.;
  for (std::uint32_t i = g.fluid; i < g.end; ++i) total += mass[group] * eos.energy(rho[i]);
  for (std::uint32_t i = 0; i + 1 < cell.first_wall.size(); ++i)
    for (std::uint32_t l = cell.first_wall[i]; l < cell.first_wall[i + 1]; ++l)
      total += wall_law.energy(
          (particles.position(g.fluid + i) - particles.position(g.begin + cell.wall[l])).norm());
  return total;
}

template <int dim>
Rates ThesisFluid<dim>::rates(const Particles<dim> &particles) const {
  Rates bound;
  const double R = parameters.support, rho = eos.reference_density(), c = eos.sound_speed(1.05 * rho);
  // As of the corrected sums (sph_fluid.cc): wave number about 6.5 / R.
  bound.fluid.frequency_squared = 6.5 * 6.5 * c * c / (R * R);
  if (parameters.viscosity > 0.)
    // sum V |W'|/r = 14/R^2 in the continuous limit, in 2D and 3D; the central drag takes 1/dim of it in one
    // direction, and the highest mode moves neighbours oppositely
    bound.fluid.drag = 2. * 14. * (parameters.law == ViscosityLaw::monaghan ? half_chi / dim : 2.) *
                       parameters.viscosity / (rho * R * R);
  // The repulsion has no upper bound; the step is for up to five times the force that holds turgor, on
  // one pair, both sides of it moving.
  const double stiffness = 2. * wall_law.stiffness_at(5. * parameters.holding_force);
  double lightest[2] = {0., 0.};  // inverse masses: wall, fluid
  for (const Group &g : particles.groups)
    for (std::uint32_t i = g.begin; i < g.end; ++i)
      lightest[i >= g.fluid] = std::max(lightest[i >= g.fluid], particles.inverse_mass[i]);
  bound.wall.frequency_squared += stiffness * lightest[0];
  bound.fluid.frequency_squared += stiffness * lightest[1];
  return bound;
}

template <int dim>
void ThesisFluid<dim>::forget_lists() {
  for (ThesisPairs<dim> &cell : cells) cell.built_at.forget();
}

template <int dim>
std::size_t ThesisFluid<dim>::crossed() const {
  std::size_t total = 0;
  for (const ThesisPairs<dim> &cell : cells) total += cell.crossed;
  return total;
}

template <int dim>
std::size_t ThesisFluid<dim>::list_builds() const {
  std::size_t total = 0;
  for (const ThesisPairs<dim> &cell : cells) total += cell.builds;
  return total;
}

template <int dim>
double ThesisFluid<dim>::mean_neighbours(const Particles<dim> &particles) const {
  std::size_t pairs = 0, n = 0;
  for (std::size_t group = 0; group < cells.size(); ++group) {
    const Group &g = particles.groups[group];
    n += g.fluid_count();
    std::array<const double *, dim> x;
    for (int d = 0; d < dim; ++d) x[d] = particles.x[d].data() + g.fluid;
    cells[group].for_fluid(x, parameters.support,
                           [&](std::uint32_t, std::uint32_t, const auto &, double) { pairs += 2; });
  }
  return n > 0 ? double(pairs) / double(n) : 0.;
}

template <int dim>
std::size_t ThesisFluid<dim>::memory_bytes() const {
  std::size_t bytes = 0;
  for (const ThesisPairs<dim> &cell : cells) bytes += cell.memory_bytes();
  return bytes;
}

template <int dim>
void ThesisFluid<dim>::archive(Archive &a, Particles<dim> &particles) {
  a.section("thesis fluid");
  a.fixed(mass, particles.field("density"));
  for (std::size_t group = 0; group < cells.size(); ++group) {
    ThesisPairs<dim> &cell = cells[group];
    a(cell.built_at);
    if (!a.loading()) continue;
    const Group &g = particles.groups[group];
    for (std::uint32_t i = g.fluid; i < g.end; ++i) particles.inverse_mass[i] = 1. / mass[group];
    if (cell.built_at.size() == g.end - g.begin) build(g, cell);
  }
}

template class ThesisFluid<2>;
template class ThesisFluid<3>;
}  // namespace turgor
