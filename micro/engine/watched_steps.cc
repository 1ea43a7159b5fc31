#include "micro/engine/watched_steps.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double most_parts = 1000.;  // beyond it the run diverges, and its own checks say so
}

template <int dim>
WatchedSteps<dim>::WatchedSteps(ParticleSystem<dim> &system_, const double fraction_,
                                const double spacings_a_step_, const double kinematic_viscosity)
    : system(system_),
      fraction(fraction_),
      spacings_a_step(spacings_a_step_),
      viscosity(kinematic_viscosity),
      plain(system_),
      control(system_, fraction_, spacings_a_step_, kinematic_viscosity) {}

template <int dim>
void WatchedSteps<dim>::begin_here() {
  control = StepControl<dim>(system, fraction, spacings_a_step, viscosity);
}

template <int dim>
void WatchedSteps<dim>::step(const double dt, const double damping) {
  // A step that is the safe one but for round-off is taken whole.
  const double parts = std::clamp(std::ceil(dt / control.dt() - 1e-9), 1., most_parts);
  for (double part = 0.; part < parts; part += 1.) plain.step(dt / parts, damping);
  extra += std::uint64_t(parts) - 1;
  control.after_step(++count);
}

template <int dim>
void WatchedSteps<dim>::archive(Archive &a) {
  a.section("watched steps");
  a(count, extra, control);
}

template class WatchedSteps<2>;
template class WatchedSteps<3>;
}  // namespace turgor
