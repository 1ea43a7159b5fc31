#include "micro/engine/respa.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
template <int dim>
Respa<dim>::Respa(ParticleSystem<dim> &system_, const unsigned int substeps_)
    : system(system_), substeps(substeps_) {
  if (substeps < 1) throw std::invalid_argument("Respa needs at least one substep.");
  for (int d = 0; d < dim; ++d) {
    slow[d].resize(system.particles.size());
    fast[d].resize(system.particles.size());
  }
}

template <int dim>
void Respa<dim>::keep(const std::size_t group, const Pace pace, Components &kept) {
  const Group &g = system.particles.groups[group];
  system.forces_of_group(group, pace);
  for (int d = 0; d < dim; ++d)
    std::copy(system.particles.f[d].begin() + g.begin, system.particles.f[d].begin() + g.end,
              kept[d].begin() + g.begin);
}

template <int dim>
void Respa<dim>::add_up(const std::size_t group) {
  const Group &g = system.particles.groups[group];
  for (int d = 0; d < dim; ++d)
    for (std::uint32_t i = g.begin; i < g.end; ++i) system.particles.f[d][i] = slow[d][i] + fast[d][i];
}

template <int dim>
void Respa<dim>::compute_forces() {
  system.prepare();
  system.for_groups([this](const std::size_t group) {
    keep(group, Pace::slow, slow);
    keep(group, Pace::fast, fast);
    add_up(group);
  });
}

template <int dim>
void Respa<dim>::step(const double dt, const double damping) {
  Particles<dim> &p = system.particles;
  const double h = dt / substeps, half = 0.5 * h, half_slow = 0.5 * dt;
  const double *im = p.inverse_mass.data();
  for (unsigned int k = 0; k < substeps; ++k) {
    system.for_groups([&](const std::size_t group) {
      const Group &g = p.groups[group];
      for (int d = 0; d < dim; ++d) {
        double *x = p.x[d].data(), *v = p.v[d].data();
        const double *f = fast[d].data(), *s = slow[d].data();
        if (k == 0)
          for (std::uint32_t i = g.begin; i < g.end; ++i) v[i] += half_slow * s[i] * im[i];
        for (std::uint32_t i = g.begin; i < g.end; ++i) {
          v[i] += half * f[i] * im[i];
          x[i] += h * v[i];
        }
      }
      system.drift_of_group(group, h);
    });
    system.advance(h);
    system.box.H += h * system.box.H_dot;
    system.prepare();
    const bool last = k + 1 == substeps;
    const double rest = std::exp(-damping * dt);
    system.for_groups([&](const std::size_t group) {
      const Group &g = p.groups[group];
      keep(group, Pace::fast, fast);
      for (int d = 0; d < dim; ++d)
        for (std::uint32_t i = g.begin; i < g.end; ++i) p.v[d][i] += half * fast[d][i] * im[i];
      if (!last) return;
      keep(group, Pace::slow, slow);
      for (int d = 0; d < dim; ++d)
        for (std::uint32_t i = g.begin; i < g.end; ++i)
          p.v[d][i] = rest * (p.v[d][i] + half_slow * slow[d][i] * im[i]);
      add_up(group);
      system.damp_group(group, dt);
    });
  }
}

template <int dim>
void Respa<dim>::archive(Archive &a) {
  a.section("respa");
  for (int d = 0; d < dim; ++d) a.fixed(slow[d], fast[d]);
}

template class Respa<2>;
template class Respa<3>;
}  // namespace turgor
