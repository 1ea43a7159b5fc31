#include "micro/engine/overdamped.h"

#include "run/binary.h"
#include "micro/engine/gathered.h"
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
/// So little is done to a cell here that a few thousand are worth no second thread.
Chunks cells_of(const std::size_t n) { return Chunks(n, 4096); }
} // namespace

Overdamped::Overdamped(const OverdampedParameters &parameters_, SphereContacts &contacts_, Friction &friction_,
                       std::function<void(Particles<3> &)> outer_, const unsigned int threads_)
  : parameters(parameters_)
  , contacts(contacts_)
  , friction(friction_)
  , outer(std::move(outer_))
  , threads(threads_)
  , dt(parameters_.first_step)
{}

void Overdamped::evaluate(Particles<3> &particles, const std::vector<double> &gamma, const double implicit_step,
                          const bool trial)
{
  fill_zero(particles.f);
  contacts.add_forces(particles, threads, trial);
  if (outer)
    outer(particles);
  if (implicit_step > 0. && outer_stiffness)
    {
      drag.assign(gamma.size(), 0.);
      outer_stiffness(particles, drag);
      for_chunks(threads, cells_of(gamma.size()), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          drag[i] = gamma[i] + implicit_step * drag[i];
      });
      friction.velocities(particles, contacts, drag, implicit_step, threads);
    }
  else
    friction.velocities(particles, contacts, gamma, implicit_step, threads);
}

void Overdamped::fill_zero(Components &values) const
{
  for_chunks(threads, cells_of(values[0].size()), [&](std::size_t begin, std::size_t end) {
    for (auto &value : values)
      std::fill(value.begin() + std::ptrdiff_t(begin), value.begin() + std::ptrdiff_t(end), 0.);
  });
}

void Overdamped::copy(const Components &from, Components &to) const
{
  for (int d = 0; d < 3; ++d)
    to[d].resize(from[d].size());
  for_chunks(threads, cells_of(from[0].size()), [&](std::size_t begin, std::size_t end) {
    for (int d = 0; d < 3; ++d)
      std::copy(from[d].begin() + std::ptrdiff_t(begin), from[d].begin() + std::ptrdiff_t(end), to[d].begin() + std::ptrdiff_t(begin));
  });
}

void Overdamped::move(Components &x, const Components &from, const double h, const Components &v) const
{
  for_chunks(threads, cells_of(x[0].size()), [&](std::size_t begin, std::size_t end) {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = begin; i < end; ++i)
        x[d][i] = from[d][i] + h * v[d][i];
  });
}

Overdamped::Change Overdamped::change_of(const Components &v)
{
  const Chunks chunks = cells_of(v[0].size());
  worst_of.resize(chunks.count());
  Change result;
  result.total = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t end) {
    double worst = 0., total = 0.;
    for (std::size_t i = begin; i < end; ++i)
      {
        double change = 0.;
        for (int d = 0; d < 3; ++d)
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

double Overdamped::step(Particles<3> &particles, const std::vector<double> &gamma, const double limit)
{
  const std::size_t n = particles.size();
  if (v_before[0].empty())
    begin_at(particles.x);
  const std::vector<double> &radius = particles.field("radius");
  const double mean_radius = sum_chunks(threads, cells_of(n), parts, [&](std::size_t begin, std::size_t end) {
                               double sum = 0.;
                               for (std::size_t i = begin; i < end; ++i)
                                 sum += radius[i];
                               return sum;
                             })
                             / double(std::max<std::size_t>(n, 1));
  const double allowed = parameters.tolerance * mean_radius;
  const bool heun = parameters.method == OverdampedMethod::heun, implicit = parameters.method == OverdampedMethod::implicit;
  if (!implicit)
    evaluate(particles, gamma, 0., false);
  copy(particles.x, x_before);
  if (heun || v_before[0].empty())
    copy(particles.v, v_before);
  for (;;)
    {
      const double h = std::min({dt, limit, parameters.longest_step});
      try
        {
          if (implicit)
            evaluate(particles, gamma, h, false);
          if (heun)
            {
              move(particles.x, x_before, h, v_before);
              evaluate(particles, gamma, 0., true);
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
          for_chunks(threads, cells_of(n), [&](std::size_t begin, std::size_t end) {
            for (int d = 0; d < 3; ++d)
              for (std::size_t i = begin; i < end; ++i)
                {
                  const double v = heun ? 0.5 * (particles.v[d][i] + v_before[d][i]) : particles.v[d][i];
                  particles.x[d][i] = x_before[d][i] + h * v;
                  v_before[d][i] = particles.v[d][i] = v;
                }
          });
          if (h >= dt || factor < 1.) // a step cut short by the limit says nothing against the long one
            dt = h * factor;
          if (random_forces)
            {
              random_forces(particles, h, accepted);
              fill_zero(particles.v);
              friction.velocities_again(particles, contacts, threads);
              move(particles.x, particles.x, h, particles.v);
              copy(v_before, particles.v);
            }
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

void Overdamped::gather(const std::vector<std::uint32_t> &source)
{
  jumped = true;
  dt = std::min(dt, 2. * after_jump);
  for (auto &v : v_before)
    if (!v.empty())
      v = gathered(v, source);
}

void Overdamped::save(std::ostream &out) const
{
  write_binary(out, dt);
  write_binary(out, last_step);
  write_binary(out, after_jump);
  write_binary(out, jumped);
  write_binary(out, rejections);
  write_binary(out, accepted);
  for (const auto &v : v_before)
    write_binary(out, v);
}

void Overdamped::load(std::istream &in)
{
  read_binary(in, dt);
  read_binary(in, last_step);
  read_binary(in, after_jump);
  read_binary(in, jumped);
  read_binary(in, rejections);
  read_binary(in, accepted);
  for (auto &v : v_before)
    read_binary(in, v);
}
} // namespace turgor
