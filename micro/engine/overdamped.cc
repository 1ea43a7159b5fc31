#include "micro/engine/overdamped.h"

#include "run/archive.h"
#include "micro/solve/step_too_long.h"
#include "run/number_text.h"
#include "run/parallel.h"
#include "run/start_disturbance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
/// So little is done to a body here that a few thousand are worth no second thread.
Chunks bodies_of(const std::size_t n) { return Chunks(n, 4096); }
}  // namespace

template <int dim>
Overdamped<dim>::Overdamped(const OverdampedParameters &parameters_, Motion<dim> &motion_,
                            const unsigned int threads_)
    : parameters(parameters_), motion(motion_), threads(threads_), dt(parameters_.first_step) {
  if (parameters.energy.on && parameters.method != OverdampedMethod::implicit)
    throw std::logic_error("only implicit steps are checked against making energy");
}

template <int dim>
void Overdamped<dim>::evaluate(Particles<dim> &particles, const double implicit_step, const bool trial) {
  motion.forces(particles, trial);
  motion.velocities(particles, implicit_step);
}

template <int dim>
void Overdamped<dim>::copy(const Components &from, Components &to) const {
  for (int d = 0; d < dim; ++d) to[d].resize(from[d].size());
  for_chunks(threads, bodies_of(from[0].size()), [&](std::size_t begin, std::size_t end) {
    for (int d = 0; d < dim; ++d)
      std::copy(from[d].begin() + std::ptrdiff_t(begin), from[d].begin() + std::ptrdiff_t(end),
                to[d].begin() + std::ptrdiff_t(begin));
  });
}

template <int dim>
void Overdamped<dim>::move(Components &x, const Components &from, const double h, const Components &v) const {
  for_chunks(threads, bodies_of(x[0].size()), [&](std::size_t begin, std::size_t end) {
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = begin; i < end; ++i) x[d][i] = from[d][i] + h * v[d][i];
  });
}

template <int dim>
typename Overdamped<dim>::Change Overdamped<dim>::change_of(const Components &v) {
  const Chunks chunks = bodies_of(v[0].size());
  worst_of.resize(chunks.count());
  Change result;
  result.total = sum_chunks(threads, chunks, parts, [&](std::size_t begin, std::size_t end) {
    double worst = 0., total = 0.;
    for (std::size_t i = begin; i < end; ++i) {
      double change = 0.;
      for (int d = 0; d < dim; ++d) change += (v[d][i] - v_before[d][i]) * (v[d][i] - v_before[d][i]);
      worst = std::max(worst, change);
      total += change;
    }
    worst_of[begin / chunks.size] = worst;
    return total;
  });
  for (const double worst : worst_of) result.worst = std::max(result.worst, worst);
  for (const MovedBodies<dim> *body : bodies) {
    const double square = body->change() * body->change();
    result.worst = std::max(result.worst, square);
    result.total += square;
  }
  return result;
}

template <int dim>
double Overdamped<dim>::fastest_body(const bool kept) const {
  double most = 0.;
  for (const MovedBodies<dim> *body : bodies)
    most = std::max(most, kept ? body->fastest_kept() : body->fastest());
  return most;
}

template <int dim>
double Overdamped<dim>::fastest_of(const Components &v) {
  const Chunks chunks = bodies_of(v[0].size());
  worst_of.assign(chunks.count(), 0.);
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double square = 0.;
      for (int d = 0; d < dim; ++d) square += v[d][i] * v[d][i];
      worst_of[begin / chunks.size] = std::max(worst_of[begin / chunks.size], square);
    }
  });
  double most = 0.;
  for (const double one : worst_of) most = std::max(most, one);
  return std::sqrt(most);
}

template <int dim>
bool Overdamped<dim>::find_velocities(Particles<dim> &particles, const double h) {
  const bool implicit = parameters.method == OverdampedMethod::implicit;
  try {
    if (implicit) evaluate(particles, h, false);
    if (parameters.method == OverdampedMethod::heun) {
      move(particles.x, x_before, h, v_before);
      for (MovedBodies<dim> *body : bodies) body->go(h);
      evaluate(particles, 0., true);
      for (MovedBodies<dim> *body : bodies) body->back();
    }
    return true;
  } catch (const StepTooLong
               &error) {  // where an implicit step begins does not depend on its length, only the matrix does
    if ((implicit && !dynamic_cast<const NotSolved *>(&error)) || 0.2 * h < parameters.least_step) throw;
    ++rejections;
    dt = 0.2 * h;
    take_back(particles);
    return false;
  }
}

template <int dim>
void Overdamped<dim>::take_back(Particles<dim> &particles) {
  copy(x_before, particles.x);
  for (MovedBodies<dim> *body : bodies) {
    body->back();
    if (parameters.method == OverdampedMethod::heun) body->start_again();
  }
}

template <int dim>
double Overdamped<dim>::checked_step(Particles<dim> &particles, const double h) {
  const Energies before = motion.energy(particles);
  const double fastest = std::max(fastest_of(particles.v), fastest_body(false)),
               longest = parameters.energy.longest_move * motion.length(particles);
  const double s = h * fastest > longest ? longest / fastest : h;
  const double lost = 0.5 * s * motion.dissipation(particles), work = motion.work_of_bodies(particles, s);
  move(particles.x, x_before, s, particles.v);
  for (MovedBodies<dim> *body : bodies) body->go(s);
  try {
    motion.forces(particles, true);
  } catch (const StepTooLong &) {
    return 0.;
  }
  const Energies after = motion.energy(particles);
  for (MovedBodies<dim> *body : bodies) body->back();
  const bool rests = s * fastest <= 1e-12 * motion.length(particles);  // positions are not known any better
  const bool falls =
      rests ||
      after.sum + lost <= before.sum + work + parameters.energy.tolerance * std::max(before.size, after.size);
  if (falls) motion.accept(particles);
  return falls ? s : 0.;
}

template <int dim>
double Overdamped<dim>::short_enough(const Particles<dim> &particles, const double h) {
  const bool heun = parameters.method == OverdampedMethod::heun;
  double fastest = std::max(fastest_of(particles.v), fastest_body(false));
  if (heun) fastest = 0.5 * (fastest + std::max(fastest_of(v_before), fastest_body(true)));
  moved = h * fastest;
  const double longest = parameters.longest_move * motion.length(particles);
  if (moved <= longest) return h;
  const double s = longest / fastest;
  if (s < parameters.least_step)
    fail("the forces drive a cell by more than " + number_text(parameters.longest_move) +
         " radii in it. Use less that drives the cells, or more friction.");
  if (heun) {
    dt = 0.9 * s;
    return 0.;
  }
  moved = longest;
  return s;
}

template <int dim>
void Overdamped<dim>::fail(const std::string &reason) const {
  throw std::runtime_error("the step fell below " + number_text(parameters.least_step) + " s: " + reason);
}

template <int dim>
void Overdamped<dim>::fail_of(const bool rose) const {
  if (rose)
    fail("every step makes energy, more than " + number_text(parameters.energy.tolerance) +
         " of the energies at play. Use softer contacts, a finer mesh of cells, or a larger tolerance of the "
         "energy.");
  fail("the cells' forces change too fast for the tolerance of " + number_text(parameters.tolerance) +
       " radii. Use " + (parameters.method == OverdampedMethod::implicit ? "" : "Method = implicit, ") +
       "a larger tolerance, or softer contacts.");
}

template <int dim>
double Overdamped<dim>::step(Particles<dim> &particles, const double limit) {
  const std::size_t n = particles.size();
  if (v_before[0].empty()) begin_at(particles.x);
  const double allowed = parameters.tolerance * motion.length(particles);
  const bool heun = parameters.method == OverdampedMethod::heun,
             implicit = parameters.method == OverdampedMethod::implicit;
  motion.begin_step(particles);
  bodies = motion.moved_bodies();
  const auto keep_bodies = [&] {
    for (MovedBodies<dim> *body : bodies) body->keep();
  };
  if (!heun) keep_bodies();  // with the velocities of the step before, which its error is measured by
  if (!implicit) evaluate(particles, 0., false);
  if (heun) keep_bodies();
  copy(particles.x, x_before);
  if (heun || v_before[0].empty()) copy(particles.v, v_before);
  for (;;) {
    const double h = std::min({dt, limit, parameters.longest_step});
    if (!find_velocities(particles, h)) continue;
    const auto [worst, total] = change_of(particles.v);
    const bool finite = std::isfinite(total);
    // What has changed since the step before, over a step of this length; a change over this very step where
    // that is known. A jump of the forces has happened at once: it may be gone as soon, however long the step
    // before was.
    double over_step = heun || implicit || !(last_step > 0.) ? 1. : h / last_step;
    if (jumped) over_step = std::max(1., over_step);
    const double largest = 0.5 * h * over_step * std::sqrt(worst);
    const double error = !parameters.mean_error ? largest
                                                : std::max(0.5 * h * over_step * std::sqrt(total / double(n)),
                                                           parameters.tolerance * 4. * largest);
    double factor = error > 0. ? std::clamp(0.9 * std::sqrt(allowed / error), 0.2, 2.) : 2.;
    const bool accurate = finite && error <= allowed;
    const double passed = !accurate              ? 0.
                          : parameters.energy.on ? checked_step(particles, h)
                                                 : short_enough(particles, h);
    if (passed > 0.) {
      for_chunks(threads, bodies_of(n), [&](std::size_t begin, std::size_t end) {
        for (int d = 0; d < dim; ++d)
          for (std::size_t i = begin; i < end; ++i) {
            const double v = heun ? 0.5 * (particles.v[d][i] + v_before[d][i]) : particles.v[d][i];
            particles.x[d][i] = x_before[d][i] + passed * v;
            v_before[d][i] = particles.v[d][i] = v;
          }
      });
      if (heun)
        for (MovedBodies<dim> *body : bodies) body->mean();
      if (parameters.energy.on) factor = std::min(factor, parameters.energy.growth) * passed / h;
      if (h >= dt || factor < 1.)  // a step cut short by the limit says nothing against the long one
        dt = h * factor;
      if (passed < h && !parameters.energy.on) dt = std::min(dt, 2. * passed);
      move_at_random(particles, passed);
      ++accepted;
      last_step = passed;
      if (jumped) after_jump = passed;
      jumped = false;
      return passed;
    }
    ++rejections;
    const bool rose = accurate && parameters.energy.on;
    rises += rose;
    if (!accurate || rose) dt = h * (accurate ? 0.5 : finite ? std::min(factor, 0.9) : 0.2);
    take_back(particles);
    if (dt < parameters.least_step) fail_of(rose);
  }
}

template <int dim>
void Overdamped<dim>::move_at_random(Particles<dim> &particles, const double h) {
  if (!motion.random_forces(particles, h, accepted)) return;
  for_chunks(threads, bodies_of(particles.size()), [&](std::size_t begin, std::size_t end) {
    for (auto &v : particles.v)
      std::fill(v.begin() + std::ptrdiff_t(begin), v.begin() + std::ptrdiff_t(end), 0.);
  });
  if (parameters.energy
          .on)  // the matrix of its last solution belongs to other positions than the lists do now
    motion.velocities(particles, h);
  else
    motion.again(particles);
  move(particles.x, particles.x, h, particles.v);
  moved += h * fastest_of(particles.v);
  copy(v_before, particles.v);
}

template <int dim>
void Overdamped<dim>::gather(const Rearrangement &places, const bool settled) {
  if (!settled) {
    jumped = true;
    dt = std::min(dt, 2. * after_jump);
  }
  for (auto &v : v_before)
    if (!v.empty()) v = places.of(v);
}

template <int dim>
void Overdamped<dim>::archive(Archive &a) {
  a.section("overdamped");
  a(dt, last_step, after_jump, jumped, rejections, accepted, rises, v_before);
}

template class Overdamped<2>;
template class Overdamped<3>;
}  // namespace turgor
