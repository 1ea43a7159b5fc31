// How the density of the thesis's fluid follows motion, jumps of positions and changes of mass
// (Eq. 2.26, 2.27).
#include "micro/terms/thesis_fluid.h"

#include <cmath>

namespace turgor {
template <int dim>
void ThesisFluid<dim>::set_particle_mass(Particles<dim> &particles, const std::size_t group,
                                         const double value) {
  const Group &g = particles.groups[group];
  std::vector<double> &rho = particles.field("density");
  const double ratio = value / mass[group];
  for (std::uint32_t i = g.fluid; i < g.end; ++i) {
    rho[i] *= ratio;
    particles.inverse_mass[i] = 1. / value;
  }
  mass[group] = value;
}

template <int dim>
void ThesisFluid<dim>::drift(Particles<dim> &particles, const std::size_t group, const double dt) {
  update_lists(particles, group);
  const Group &g = particles.groups[group];
  const std::uint32_t n = g.fluid_count();
  thread_local std::vector<double> middle[dim], change;
  change.assign(n, 0.);
  for (int d = 0; d < dim; ++d) {
    middle[d].resize(n);
    for (std::uint32_t i = 0; i < n; ++i)
      middle[d][i] = particles.x[d][g.fluid + i] - 0.5 * dt * particles.v[d][g.fluid + i];
  }
  std::array<const double *, dim> x, v;
  for (int d = 0; d < dim; ++d) {
    x[d] = middle[d].data();
    v[d] = particles.v[d].data() + g.fluid;
  }
  cells[group].for_fluid(x, parameters.support,
                         [&](std::uint32_t i, std::uint32_t j, const auto &r, double r2) {
                           double approach = 0.;
                           for (int d = 0; d < dim; ++d) approach += (v[d][j] - v[d][i]) * r[d];
                           const double rate = slope_over_r(r2) * approach;
                           change[i] += rate;
                           change[j] += rate;
                         });
  double *rho = particles.field("density").data() + g.fluid;
  for (std::uint32_t i = 0; i < n; ++i) rho[i] += dt * mass[group] * change[i];
}

template <int dim>
void ThesisFluid<dim>::jumped(Particles<dim> &particles, const typename Particles<dim>::Components &before) {
  for (std::size_t group = 0; group < cells.size(); ++group) {
    const Group &g = particles.groups[group];
    ThesisPairs<dim> &cell = cells[group];
    double *rho = particles.field("density").data() + g.fluid;
    for (const auto *positions :
         {&before, &static_cast<const typename Particles<dim>::Components &>(particles.x)}) {
      cell.built_at.take(*positions, g);
      build(g, cell);
      std::array<const double *, dim> x;
      for (int d = 0; d < dim; ++d) x[d] = (*positions)[d].data() + g.fluid;
      const double share = (positions == &before ? -1. : 1.) * mass[group] / parameters.depth;
      cell.for_fluid(x, parameters.support, [&](std::uint32_t i, std::uint32_t j, const auto &, double r2) {
        const double change = share * kernel.value(std::sqrt(r2));
        rho[i] += change;
        rho[j] += change;
      });
    }
  }
}

#define TURGOR_INSTANTIATE(dim)                                                             \
  template void ThesisFluid<dim>::set_particle_mass(Particles<dim> &, std::size_t, double); \
  template void ThesisFluid<dim>::drift(Particles<dim> &, std::size_t, double);             \
  template void ThesisFluid<dim>::jumped(Particles<dim> &, const typename Particles<dim>::Components &);
TURGOR_INSTANTIATE(2)
TURGOR_INSTANTIATE(3)
#undef TURGOR_INSTANTIATE
}  // namespace turgor
