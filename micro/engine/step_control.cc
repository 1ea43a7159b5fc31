#include "micro/engine/step_control.h"

#include "run/archive.h"
#include "micro/engine/measured_step.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr std::uint64_t steps_between_looks = 100;
constexpr double smoothing = 40.;  // of viscosity, over the Reynolds number of a spacing
constexpr double alike = 1e-9;     // cells whose spacings differ by less than that are copies of one cell,
                                   // round-off of their places apart

/// m, of the particles of every cell: its box shared out among them.
template <int dim>
std::vector<double> spacings(const Particles<dim> &p) {
  std::vector<double> all;
  for (const Group &g : p.groups) {
    double volume = 1.;
    for (int d = 0; d < dim; ++d) {
      const auto [low, high] = std::minmax_element(p.x[d].begin() + g.begin, p.x[d].begin() + g.end);
      volume *= *high - *low;
    }
    const double own = std::pow(volume / double(g.end - g.begin), 1. / dim);
    all.push_back(!all.empty() && std::abs(own - all.front()) <= alike * all.front() ? all.front() : own);
  }
  return all;
}
}  // namespace

template <int dim>
StepControl<dim>::StepControl(ParticleSystem<dim> &system_, const double fraction_,
                              const double spacings_a_step_, const double kinematic_viscosity)
    : system(&system_),
      fraction(fraction_),
      spacings_a_step(spacings_a_step_),
      viscosity(kinematic_viscosity) {
  const double bound = system->stable_time_step();
  step = fraction * std::min(bound, measure_stable_step(*system, bound).dt);
  spacing = spacings(system->particles);
  step = std::min(step, step_of_speed());
  remember();
}

template <int dim>
double StepControl<dim>::step_of_speed() const {
  const Particles<dim> &p = system->particles;
  double shortest = HUGE_VAL;
  for (std::size_t c = 0; c < p.groups.size(); ++c) {
    const Group &g = p.groups[c];
    double mean[dim]{};
    for (int d = 0; d < dim; ++d) {
      for (std::uint32_t i = g.begin; i < g.end; ++i) mean[d] += p.v[d][i];
      mean[d] /= g.end - g.begin;
    }
    double square = 0.;
    for (std::uint32_t i = g.begin; i < g.end; ++i)
      for (int d = 0; d < dim; ++d) square += (p.v[d][i] - mean[d]) * (p.v[d][i] - mean[d]);
    const double v = std::sqrt(square / (g.end - g.begin));
    if (v > 0.) shortest = std::min(shortest, spacings_a_step * (spacing[c] + smoothing * viscosity / v) / v);
  }
  return shortest;
}

template <int dim>
void StepControl<dim>::remember() {
  looked_at = system->particles.x;
}

template <int dim>
bool StepControl<dim>::moved() const {
  const Particles<dim> &p = system->particles;
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (int d = 0; d < dim; ++d) {
      const Group &g = p.groups[c];
      double mean = 0., low = HUGE_VAL, high = -HUGE_VAL;
      for (std::uint32_t i = g.begin; i < g.end; ++i) {
        const double move = p.x[d][i] - looked_at[d][i];
        mean += move;
        low = std::min(low, move);
        high = std::max(high, move);
      }
      mean /= g.end - g.begin;
      if (!(high - mean < spacing[c] && mean - low < spacing[c]))  // also where something is not finite
        return true;
    }
  return false;
}

template <int dim>
bool StepControl<dim>::after_step(const std::uint64_t count) {
  if (count % steps_between_looks != 0) return false;
  const double before = step, allowed = step_of_speed();
  if (allowed > 0.)  // a speed that is not finite is for the scene's own checks
    step = std::min(step, allowed);
  if (moved()) {
    remember();
    // Stable still, at dt / fraction?
    if (step_eigenvalue(*system, step / fraction) > 4.)
      step = std::min(step, fraction * measure_stable_step(*system, step / fraction).dt);
  }
  return step < before;
}

template <int dim>
void StepControl<dim>::archive(Archive &a) {
  a.section("step control");
  a(step, looked_at);
}

template class StepControl<2>;
template class StepControl<3>;
}  // namespace turgor
