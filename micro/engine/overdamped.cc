#include "micro/engine/overdamped.h"

#include "run/archive.h"
#include "micro/solve/step_too_long.h"
#include "run/parallel.h"
#include "run/start_disturbance.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace turgor
{
namespace
{
/// So little is done to a body here that a few thousand are worth no second thread.
Chunks bodies_of(const std::size_t n) { return Chunks(n, 4096); }
} // namespace

template <int dim>
Overdamped<dim>::Overdamped(const OverdampedParameters &parameters_, Motion<dim> &motion_, const unsigned int threads_)
  : parameters(parameters_)
  , motion(motion_)
  , threads(threads_)
  , dt(parameters_.first_step)
{}

template <int dim>
void Overdamped<dim>::evaluate(Particles<dim> &particles, const double implicit_step, const bool trial)
{
  motion.forces(particles, trial);
  motion.velocities(particles, implicit_step);
}

template <int dim>
void Overdamped<dim>::copy(const Components &from, Components &to) const
{
  for (int d = 0; d < dim; ++d)
    to[d].resize(from[d].size());
  for_chunks(threads, bodies_of(from[0].size()), [&](std::size_t begin, std::size_t end) {
    for (int d = 0; d < dim; ++d)
      std::copy(from[d].begin() + std::ptrdiff_t(begin), from[d].begin() + std::ptrdiff_t(end), to[d].begin() + std::ptrdiff_t(begin));
  });
}

template <int dim>
void Overdamped<dim>::move(Components &x, const Components &from, const double h, const Components &v) const
{
  for_chunks(threads, bodies_of(x[0].size()), [&](std::size_t begin, std::size_t end) {
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = begin; i < end; ++i)
        x[d][i] = from[d][i] + h * v[d][i];
  });
}

template <int dim>
typename Overdamped<dim>::Change Overdamped<dim>::change_of(const Components &v)
{
  const Chunks chunks = bodies_of(v[0].size());
  worst_of.resize(chunks.count());
  Change result;
  result.total = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t end) {
    double worst = 0., total = 0.;
    for (std::size_t i = begin; i < end; ++i)
      {
        double change = 0.;
        for (int d = 0; d < dim; ++d)
          change += (v[d][i] - v_before[d][i]) * (v[d][i] - v_before[d][i]);
        worst = std::max(worst, change);
        total += change;
      }
    worst_of[begin / chunks.size] = worst;
    return total;
  });
  for (const double worst : worst_of)
    result.worst = std::max(result.worst, worst);
  return result;
}

template <int dim>
double Overdamped<dim>::step(Particles<dim> &particles, const double limit)
{
  const std::size_t n = particles.size();
  if (v_before[0].empty())
    begin_at(particles.x);
  const double allowed = parameters.tolerance * motion.length(particles);
  const bool heun = parameters.method == OverdampedMethod::heun, implicit = parameters.method == OverdampedMethod::implicit;
  if (!implicit)
    evaluate(particles, 0., false);
  copy(particles.x, x_before);
  if (heun || v_before[0].empty())
    copy(particles.v, v_before);
  for (;;)
    {
      const double h = std::min({dt, limit, parameters.longest_step});
      try
        {
          if (implicit)
            evaluate(particles, h, false);
          if (heun)
            {
              move(particles.x, x_before, h, v_before);
              evaluate(particles, 0., true);
            }
        }
      catch (const StepTooLong &error)
        { // where an implicit step begins does not depend on its length, only the matrix does
          if ((implicit && !dynamic_cast<const NotSolved *>(&error)) || 0.2 * h < parameters.least_step)
            throw;
          ++rejections;
          dt = 0.2 * h;
          copy(x_before, particles.x);
          continue;
        }
      const auto [worst, total] = change_of(particles.v);
      const bool finite = std::isfinite(total);
      // What has changed since the step before, over a step of this length; a change over this very step where that is known.
      const double over_step = heun || implicit || !(last_step > 0.) ? 1. : h / last_step;
      const double largest = 0.5 * h * over_step * std::sqrt(worst);
      const double error = !parameters.mean_error ? largest :
                                                    std::max(0.5 * h * over_step * std::sqrt(total / double(n)), parameters.tolerance * 4. * largest);
      const double factor = error > 0. ? std::clamp(0.9 * std::sqrt(allowed / error), 0.2, 2.) : 2.;
      if (finite && error <= allowed)
        {
          for_chunks(threads, bodies_of(n), [&](std::size_t begin, std::size_t end) {
            for (int d = 0; d < dim; ++d)
              for (std::size_t i = begin; i < end; ++i)
                {
                  const double v = heun ? 0.5 * (particles.v[d][i] + v_before[d][i]) : particles.v[d][i];
                  particles.x[d][i] = x_before[d][i] + h * v;
                  v_before[d][i] = particles.v[d][i] = v;
                }
          });
          if (h >= dt || factor < 1.) // a step cut short by the limit says nothing against the long one
            dt = h * factor;
          move_at_random(particles, h);
          ++accepted;
          last_step = h;
          if (jumped)
            after_jump = h;
          jumped = false;
          return h;
        }
      ++rejections;
      dt = h * (finite ? std::min(factor, 0.9) : 0.2);
      copy(x_before, particles.x);
      if (dt < parameters.least_step)
        {
          std::ostringstream text;
          text << "the step fell below " << parameters.least_step << " s: the cells' forces change too fast for the tolerance of "
               << parameters.tolerance << " radii. Use Method = implicit, a larger tolerance, or softer contacts.";
          throw std::runtime_error(text.str());
        }
    }
}

template <int dim>
void Overdamped<dim>::move_at_random(Particles<dim> &particles, const double h)
{
  if (!motion.random_forces(particles, h, accepted))
    return;
  for_chunks(threads, bodies_of(particles.size()), [&](std::size_t begin, std::size_t end) {
    for (auto &v : particles.v)
      std::fill(v.begin() + std::ptrdiff_t(begin), v.begin() + std::ptrdiff_t(end), 0.);
  });
  motion.again(particles);
  move(particles.x, particles.x, h, particles.v);
  copy(v_before, particles.v);
}

template <int dim>
void Overdamped<dim>::gather(const Rearrangement &places)
{
  jumped = true;
  dt = std::min(dt, 2. * after_jump);
  for (auto &v : v_before)
    if (!v.empty())
      v = places.of(v);
}

template <int dim>
void Overdamped<dim>::archive(Archive &a)
{
  a.section("overdamped");
  a(dt, last_step, after_jump, jumped, rejections, accepted, v_before);
}

template class Overdamped<2>;
template class Overdamped<3>;
} // namespace turgor
