#include "micro/engine/system_motion.h"

#include "run/parallel.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
namespace {
/// So little is done to a particle here that a few thousand are worth no second thread.
Chunks particles_of(const std::size_t n) { return Chunks(n, 4096); }

template <int dim>
void take_mean_out(typename Particles<dim>::Components &values) {
  for (auto &component : values) {
    double sum = 0.;
    for (const double one : component) sum += one;
    for (double &one : component) one -= sum / double(component.size());
  }
}
}  // namespace

template <int dim>
SystemMotion<dim>::SystemMotion(ParticleSystem<dim> &system_, const SolveParameters &solve)
    : system(system_), matrix(solve), friction(solve) {}

template <int dim>
void SystemMotion<dim>::forces(Particles<dim> &, const bool trial) {
  friction_collected = false;
  if (!forces_known || trial) system.compute_forces(trial);
  forces_known = false;
}

template <int dim>
void SystemMotion<dim>::put_bodies(const Particles<dim> &particles,
                                   const std::vector<MovedBodies<dim> *> &bodies) {
  all.medium = medium;
  all.f = particles.f;
  all.v = particles.v;
  for (MovedBodies<dim> *body : bodies) body->put(all.medium, all.f, all.v);
}

template <int dim>
void SystemMotion<dim>::solve_with_bodies(Particles<dim> &particles,
                                          const std::vector<MovedBodies<dim> *> &bodies, const double h) {
  if (correct_clusters || remove_mean || !inertia.empty())
    throw std::logic_error(
        "beside bodies that forces move clusters are not corrected, and nothing has inertia");
  put_bodies(particles, bodies);
  matrix.clear(all.medium);
  system.collect(matrix, h);
  matrix.template solve<dim>(all.f, all.v, system.threads);
  for (int d = 0; d < dim; ++d) std::copy_n(all.v[d].begin(), particles.v[d].size(), particles.v[d].begin());
  for (MovedBodies<dim> *body : bodies) body->take(all.v);
}

template <int dim>
void SystemMotion<dim>::begin_step(const Particles<dim> &particles) {
  if (!inertia.empty()) started = particles.v;
}

template <int dim>
void SystemMotion<dim>::velocities(Particles<dim> &particles, const double h) {
  all = {};
  if (const auto bodies = moved_bodies(); !bodies.empty()) return solve_with_bodies(particles, bodies, h);
  if (remove_mean) take_mean_out<dim>(particles.f);
  matrix.clear(medium);
  if (!inertia.empty()) {
    if (!(h > 0.)) throw std::logic_error("inertia needs implicit steps");
    for (std::size_t i = 0; i < inertia.size(); ++i) {
      matrix.medium[i] += inertia[i] / h;
      for (int d = 0; d < dim; ++d) particles.f[d][i] += inertia[i] / h * started[d][i];
    }
  }
  system.collect(matrix, h);
  if (correct_clusters) matrix.template correct_clusters<dim>(particles.x);
  if constexpr (dim == 3)
    if (second_level_from > 0 && particles.groups.size() >= second_level_from) {
      std::vector<std::uint32_t> first;
      for (const Group &group : particles.groups) first.push_back(group.begin);
      first.push_back(particles.groups.back().end);
      matrix.second_level(first, particles.x);
    }
  matrix.template solve<dim>(particles.f, particles.v, system.threads);
  if (remove_mean) take_mean_out<dim>(particles.v);
}

template <int dim>
void SystemMotion<dim>::accept(Particles<dim> &) {
  system.accept();
}

template <int dim>
Energies SystemMotion<dim>::energy(const Particles<dim> &) const {
  return system.energies();
}

template <int dim>
Power SystemMotion<dim>::friction_power(const Particles<dim> &particles) {
  if (!friction_collected) {
    friction.clear(all.medium.empty() ? medium : all.medium);
    system.collect(friction, 0.);
    friction_collected = true;
  }
  return friction.template power<dim>(all.medium.empty() ? particles.v : all.v, system.threads);
}

template <int dim>
double SystemMotion<dim>::dissipation(Particles<dim> &particles) {
  dissipated = friction_power(particles).lost;
  return dissipated;
}

template <int dim>
double SystemMotion<dim>::work_of_bodies(Particles<dim> &particles, const double h) {
  double total = system.active_work(h);
  for (const MovedBodies<dim> *body : moved_bodies()) total += body->work_of_loads(h);
  if (matrix.moves_bodies()) {  // by friction; and the push that h K foresees
    const Power by_friction = friction_power(particles);
    total +=
        h * (by_friction.given +
             matrix.template power<dim>(all.medium.empty() ? particles.v : all.v, system.threads).pushed -
             by_friction.pushed);
  }
  return total;
}

template <int dim>
void SystemMotion<dim>::again(Particles<dim> &particles) {
  if (all.medium.empty()) return matrix.template again<dim>(particles.f, particles.v, system.threads);
  // The bodies give way to what is pushed against them, but forces that act on particles alone (random ones)
  // are no motion of theirs.
  for (int d = 0; d < dim; ++d) {
    std::copy(particles.f[d].begin(), particles.f[d].end(), all.f[d].begin());
    std::fill(all.f[d].begin() + std::ptrdiff_t(particles.f[d].size()), all.f[d].end(), 0.);
    std::copy(particles.v[d].begin(), particles.v[d].end(), all.v[d].begin());
  }
  matrix.template again<dim>(all.f, all.v, system.threads);
  for (int d = 0; d < dim; ++d) std::copy_n(all.v[d].begin(), particles.v[d].size(), particles.v[d].begin());
}

template <int dim>
bool SystemMotion<dim>::random_forces(Particles<dim> &, const double h, const std::uint64_t step) {
  return system.random_forces(medium, h, step);
}

template <int dim>
double SystemMotion<dim>::length(const Particles<dim> &particles) const {
  if (own_length > 0.) return own_length;
  const std::vector<double> &radius = particles.field("radius");
  std::vector<double> parts;
  const double sum =
      sum_chunks(system.threads, particles_of(radius.size()), parts, [&](std::size_t begin, std::size_t end) {
        double part = 0.;
        for (std::size_t i = begin; i < end; ++i) part += radius[i];
        return part;
      });
  return sum / double(std::max<std::size_t>(radius.size(), 1));
}

template class SystemMotion<2>;
template class SystemMotion<3>;
}  // namespace turgor
