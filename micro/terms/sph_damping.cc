// The viscosity of the SPH fluid that acts by impulses (sph_impulses.h, sph_viscosity.inc.h).
#include "micro/terms/sph_fluid.h"
#include "micro/terms/sph_scratch.h"
#include "micro/terms/sph_wall_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor {
template <int dim>
std::array<std::vector<double>, dim> SphFluid<dim>::viscous_forces(const Particles<dim> &particles,
                                                                   const std::size_t group) const {
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.fluid_count(), nw = g.wall_count();
  std::array<std::vector<double>, dim> f;
  for (auto &component : f) component.assign(nw + n, 0.);
  const Cell &cell = cells[group];
  if (n == 0 || !cell.built) return f;
  const std::size_t rows = std::size_t(n + 1) * sph::viscous_row<dim>;
  WallView<dim> wall(cell.lists.wall, g, {parameters.depth, true, mesh.get()});
  thread_local SphScratch scratch;
  double *memory = scratch.get(2 * rows + wall.doubles());

  sph::CellView<dim> view;
  view.n = n;
  view.viscous_rows = memory;
  view.moments = memory + rows;
  wall.attach(view, particles, memory + 2 * rows);
  view.support = parameters.support;
  view.depth = parameters.depth;
  view.viscosity = parameters.viscosity;
  view.particle_volume =
      open(group) || !(wall.volume() > 0.) ? mass[group] / eos.reference_density() : wall.volume() / n;
  view.neighbours = cell.lists.fluid.neighbours.data();
  view.first_neighbour = cell.lists.fluid.first_neighbour.data();
  double *on_wall[dim];
  for (int d = 0; d < dim; ++d) {
    view.x[d] = particles.x[d].data() + g.fluid;
    view.v[d] = particles.v[d].data() + g.fluid;
    view.f[d] = f[d].data() + nw;
    on_wall[d] = f[d].data();
  }
  sph::sweeps<dim>().viscosity(view);
  wall.add_forces(view, on_wall);
  return f;
}

namespace {
constexpr double stiff = 8.;  ///< most time between impulses over the fastest rate (a step, if that is
                              ///< longer): of a history 0.7 %; 4: 0.2 % (doc/performance.md)

constexpr double round_off = 1e-12;

template <int dim>
using VelocitiesOf = std::array<std::vector<double>, dim>;

/// J, of all particles of a group; infinite where some are moved from outside and may give any energy.
template <int dim>
double kinetic_energy(const Particles<dim> &particles, const Group &g) {
  double twice = 0.;
  for (std::uint32_t i = g.begin; i < g.end; ++i)
    for (int d = 0; d < dim; ++d)
      twice += particles.inverse_mass[i] > 0.
                   ? particles.v[d][i] * particles.v[d][i] / particles.inverse_mass[i]
                   : std::numeric_limits<double>::infinity();
  return 0.5 * twice;
}

/// J: what forces f (N) acting for a time (s) take from the motion, v from `start` to what the particles have
/// now; -time sum f . v at their mean. Of a particle with mass that is its own loss to the last digit; one
/// that is moved from outside has f . v done on it.
template <int dim>
double taken_from_the_motion(const Particles<dim> &particles, const Group &g, const VelocitiesOf<dim> &start,
                             const VelocitiesOf<dim> &f, const double time) {
  double sum = 0.;
  for (int d = 0; d < dim; ++d)
    for (std::uint32_t i = g.begin; i < g.end; ++i)
      sum += f[d][i - g.begin] * (start[d][i - g.begin] + particles.v[d][i]);
  return -0.5 * time * sum;
}

/// N m: - sum f (x) x.
template <int dim>
Tensor2<dim> virial_of(const Particles<dim> &particles, const Group &g,
                       const std::array<std::vector<double>, dim> &f) {
  Tensor2<dim> virial;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) {
      double sum = 0.;
      for (std::uint32_t i = g.begin; i < g.end; ++i) sum += f[a][i - g.begin] * particles.x[b][i];
      virial(a, b) = -sum;
    }
  return virial;
}
}  // namespace

template <int dim>
void SphFluid<dim>::drift(Particles<dim> &, const std::size_t group, double) {
  cells[group].impulses.within_step = true;
}

template <int dim>
void SphFluid<dim>::damp(Particles<dim> &particles, const Box<dim> &, const std::size_t group,
                         const double dt) {
  if (!(parameters.viscosity > 0.) || !(dt > 0.)) return;
  SphImpulses<dim> &impulses = cells[group].impulses;
  if (!impulses.due(dt)) return;
  const Group &g = particles.groups[group];
  const double bound = damping_bound(particles, group);
  impulses.longest = std::min(SphImpulses<dim>::longest_time(parameters.support / 2.6,
                                                             parameters.viscosity / eos.reference_density()),
                              stiff / bound);
  VelocitiesOf<dim> start;
  for (int d = 0; d < dim; ++d)
    start[d].assign(particles.v[d].begin() + g.begin, particles.v[d].begin() + g.end);
  // The bound holds for cells that are nearly as they were laid out. Where one has been drawn out so far that
  // a mode is faster, the polynomial would feed it; drag cannot, so the impulse is taken again with a higher
  // rate, which this cell then keeps.
  const double before = kinetic_energy(particles, g);
  for (;;) {
    const int degree = impulses.degree(impulses.excess * bound);
    const VelocitiesOf<dim> mean = impulse(particles, group, start, impulses.waited, degree);
    if (!(kinetic_energy(particles, g) > before * (1. + round_off)) ||
        degree >= SphImpulses<dim>::most_degree) {
      impulses.virial = virial_of<dim>(particles, g, mean);
      cells[group].heat += taken_from_the_motion<dim>(particles, g, start, mean, impulses.waited);
      break;
    }
    impulses.excess *= 2.;
  }
  impulses.waited = 0.;
  impulses.fresh = false;
  impulses.virial_known = true;
}

/// By the recurrence of the mean force over the time since the last impulse, v_j = v_0 + t M^-1 f_j. Returns
/// the mean force, N.
template <int dim>
std::array<std::vector<double>, dim> SphFluid<dim>::impulse(Particles<dim> &particles,
                                                            const std::size_t group,
                                                            const std::array<std::vector<double>, dim> &start,
                                                            const double time, const int degree) const {
  const Group &g = particles.groups[group];
  const std::size_t n = g.end - g.begin;
  std::array<std::vector<double>, dim> before, mean;
  for (int d = 0; d < dim; ++d) {
    before[d].assign(n, 0.);
    mean[d].assign(n, 0.);
    std::copy(start[d].begin(), start[d].end(), particles.v[d].begin() + g.begin);
  }
  for (int j = 1; j <= degree; ++j) {
    const std::array<std::vector<double>, dim> f = viscous_forces(particles, group);
    const double last = (2. * j - 1.) / j, one_before = (1. - j) / j,
                 now = last * 2. / (degree * (degree + 1.));
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = 0; i < n; ++i) {
        const double next = last * mean[d][i] + one_before * before[d][i] + now * f[d][i];
        before[d][i] = mean[d][i];
        mean[d][i] = next;
        particles.v[d][g.begin + i] = start[d][i] + time * particles.inverse_mass[g.begin + i] * next;
      }
  }
  return mean;
}

template <int dim>
Tensor2<dim> SphFluid<dim>::damping_virial(const Particles<dim> &particles, const std::size_t group) const {
  if (!(parameters.viscosity > 0.)) return Tensor2<dim>::Zero();
  const SphImpulses<dim> &impulses = cells[group].impulses;
  return impulses.virial_known
             ? impulses.virial
             : virial_of<dim>(particles, particles.groups[group], viscous_forces(particles, group));
}

template <int dim>
double SphFluid<dim>::damping_bound(const Particles<dim> &particles, const std::size_t group) const {
  const Group &g = particles.groups[group];
  const auto lightest = [&](const std::uint32_t from, const std::uint32_t to) {
    return from < to
               ? *std::max_element(particles.inverse_mass.begin() + from, particles.inverse_mass.begin() + to)
               : 0.;
  };
  const double R = parameters.support, dx = R / 2.6;
  // In the highest mode neighbours move oppositely and no velocity gradient is seen: 2 beta times twice sum w
  // = 14/R^2.
  const double volume = mass[group] / eos.reference_density();
  double bound = 56. * (4. / 3.) / (R * R) * volume * lightest(g.fluid, g.end);
  if (g.wall_count() > 0) {
    const WallBulk wall = WallView<dim>::bulk(particles, g, {parameters.depth, false, mesh.get()});
    const double width = dim == 2 ? parameters.depth : std::sqrt(wall.node_area);
    bound += (3.1 * wall.node_area / dx + 1.3 * width) * lightest(g.begin, g.fluid);
  }
  return parameters.viscosity * bound;
}

#define TURGOR_INSTANTIATE(dim)                                                                        \
  template std::array<std::vector<double>, dim> SphFluid<dim>::viscous_forces(const Particles<dim> &,  \
                                                                              std::size_t) const;      \
  template std::array<std::vector<double>, dim> SphFluid<dim>::impulse(                                \
      Particles<dim> &, std::size_t, const std::array<std::vector<double>, dim> &, double, int) const; \
  template void SphFluid<dim>::drift(Particles<dim> &, std::size_t, double);                           \
  template void SphFluid<dim>::damp(Particles<dim> &, const Box<dim> &, std::size_t, double);          \
  template Tensor2<dim> SphFluid<dim>::damping_virial(const Particles<dim> &, std::size_t) const;      \
  template double SphFluid<dim>::damping_bound(const Particles<dim> &, std::size_t) const;
TURGOR_INSTANTIATE(2)
TURGOR_INSTANTIATE(3)
}  // namespace turgor
