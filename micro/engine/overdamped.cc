#include "micro/engine/overdamped.h"

#include "micro/engine/binary.h"
#include "micro/engine/gathered.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace turgor
{
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
  for (auto &f : particles.f)
    std::fill(f.begin(), f.end(), 0.);
  contacts.add_forces(particles, threads, trial);
  if (outer)
    outer(particles);
  if (implicit_step > 0. && outer_stiffness)
    {
      drag.assign(gamma.size(), 0.);
      outer_stiffness(particles, drag);
      for (std::size_t i = 0; i < gamma.size(); ++i)
        drag[i] = gamma[i] + implicit_step * drag[i];
      friction.velocities(particles, contacts, drag, implicit_step, threads);
    }
  else
    friction.velocities(particles, contacts, gamma, implicit_step, threads);
}

double Overdamped::step(Particles<3> &particles, const std::vector<double> &gamma, const double limit)
{
  const std::size_t n = particles.size();
  const std::vector<double> &radius = particles.field("radius");
  double mean_radius = 0.;
  for (const double R : radius)
    mean_radius += R / double(n);
  const double allowed = parameters.tolerance * mean_radius;
  const bool heun = parameters.method == OverdampedMethod::heun, implicit = parameters.method == OverdampedMethod::implicit;
  if (!implicit)
    evaluate(particles, gamma, 0., false);
  for (int d = 0; d < 3; ++d)
    {
      x_before[d] = particles.x[d];
      if (heun || v_before[d].empty())
        v_before[d] = particles.v[d];
    }
  for (;;)
    {
      const double h = std::min({dt, limit, parameters.longest_step});
      if (implicit)
        evaluate(particles, gamma, h, false);
      if (heun)
        {
          for (int d = 0; d < 3; ++d)
            for (std::size_t i = 0; i < n; ++i)
              particles.x[d][i] = x_before[d][i] + h * v_before[d][i];
          evaluate(particles, gamma, 0., true);
        }
      double worst = 0., total = 0.;
      bool finite = true;
      for (std::size_t i = 0; i < n; ++i)
        {
          double change = 0.;
          for (int d = 0; d < 3; ++d)
            change += (particles.v[d][i] - v_before[d][i]) * (particles.v[d][i] - v_before[d][i]);
          finite = finite && std::isfinite(change);
          worst = std::max(worst, change);
          total += change;
        }
      const double largest = 0.5 * h * std::sqrt(worst);
      const double error = !parameters.mean_error ? largest :
                                                    std::max(0.5 * h * std::sqrt(total / double(n)), parameters.tolerance * 4. * largest);
      const double factor = error > 0. ? std::clamp(0.9 * std::sqrt(allowed / error), 0.2, 2.) : 2.;
      if (finite && error <= allowed)
        {
          for (int d = 0; d < 3; ++d)
            for (std::size_t i = 0; i < n; ++i)
              {
                const double v = heun ? 0.5 * (particles.v[d][i] + v_before[d][i]) : particles.v[d][i];
                particles.x[d][i] = x_before[d][i] + h * v;
                v_before[d][i] = particles.v[d][i] = v;
              }
          if (h >= dt || factor < 1.) // a step cut short by the limit says nothing against the long one
            dt = h * factor;
          if (random_forces)
            {
              random_forces(particles, h, accepted);
              for (auto &v : particles.v)
                std::fill(v.begin(), v.end(), 0.);
              friction.velocities_again(particles, contacts, threads);
              for (int d = 0; d < 3; ++d)
                for (std::size_t i = 0; i < n; ++i)
                  particles.x[d][i] += h * particles.v[d][i];
              for (int d = 0; d < 3; ++d)
                particles.v[d] = v_before[d];
            }
          ++accepted;
          if (jumped)
            after_jump = h;
          jumped = false;
          return h;
        }
      ++rejections;
      dt = h * (finite ? std::min(factor, 0.9) : 0.2);
      for (int d = 0; d < 3; ++d)
        particles.x[d] = x_before[d];
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
  read_binary(in, after_jump);
  read_binary(in, jumped);
  read_binary(in, rejections);
  read_binary(in, accepted);
  for (auto &v : v_before)
    read_binary(in, v);
}
} // namespace turgor
