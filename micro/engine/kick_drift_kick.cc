#include "micro/engine/kick_drift_kick.h"

#include <cmath>

namespace turgor {
template <int dim>
KickDriftKick<dim>::KickDriftKick(ParticleSystem<dim> &system_) : system(system_) {}

template <int dim>
void KickDriftKick<dim>::step(const double dt, const double damping) {
  Particles<dim> &p = system.particles;
  const double half = 0.5 * dt;
  system.for_groups([&](std::size_t group) {
    const Group &g = p.groups[group];
    const double *im = p.inverse_mass.data();
    for (int d = 0; d < dim; ++d) {
      double *x = p.x[d].data(), *v = p.v[d].data();
      const double *f = p.f[d].data();
      for (std::uint32_t i = g.begin; i < g.end; ++i) {
        v[i] += half * f[i] * im[i];
        x[i] += dt * v[i];
      }
    }
    system.drift_of_group(group, dt);
  });
  system.advance(dt);
  system.box.H += dt * system.box.H_dot;
  system.prepare();
  const double keep = std::exp(-damping * dt);
  system.for_groups([&](std::size_t group) {
    const Group &g = p.groups[group];
    system.forces_of_group(group);
    const double *im = p.inverse_mass.data();
    for (int d = 0; d < dim; ++d) {
      double *v = p.v[d].data();
      const double *f = p.f[d].data();
      if (damping > 0.)
        for (std::uint32_t i = g.begin; i < g.end; ++i) v[i] = keep * (v[i] + half * f[i] * im[i]);
      else
        for (std::uint32_t i = g.begin; i < g.end; ++i) v[i] += half * f[i] * im[i];
    }
    system.damp_group(group, dt);
  });
}

template class KickDriftKick<2>;
template class KickDriftKick<3>;
}  // namespace turgor
