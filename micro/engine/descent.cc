#include "micro/engine/descent.h"

#include "micro/engine/at_rest.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double first_share = 0.1, share_decay = 0.99;
constexpr unsigned int patience = 5;
}  // namespace

template <int dim>
Descent<dim>::Descent(ParticleSystem<dim> &system_) : system(system_), integrator(system_) {
  stop();
}

template <int dim>
void Descent<dim>::stop() {
  halt(system.particles);
  share = first_share;
  downhill = 0;
}

template <int dim>
void Descent<dim>::step(const double dt) {
  integrator.step(dt);
  Particles<dim> &p = system.particles;
  double power = 0., motion = 0., pull = 0.;
  for (int d = 0; d < dim; ++d)
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.inverse_mass[i] == 0.) continue;  // held
      power += p.f[d][i] * p.v[d][i];
      motion += p.v[d][i] * p.v[d][i] / p.inverse_mass[i];
      pull += p.f[d][i] * p.f[d][i] * p.inverse_mass[i];
    }
  if (!(power > 0.)) {
    stop();
    ++stops;
    return;
  }
  const double along = share * std::sqrt(motion / pull);
  for (int d = 0; d < dim; ++d)
    for (std::size_t i = 0; i < p.size(); ++i)
      p.v[d][i] = (1. - share) * p.v[d][i] + along * p.f[d][i] * p.inverse_mass[i];
  if (++downhill > patience) share *= share_decay;
}

template <int dim>
void Descent<dim>::archive(Archive &a) {
  a.section("descent");
  a(share, downhill, stops);
}

template class Descent<2>;
template class Descent<3>;
}  // namespace turgor
