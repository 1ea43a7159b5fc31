#include "micro/engine/particle_system.h"

#include "run/archive.h"
#include "run/parallel.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace turgor {
template <int dim>
void ParticleSystem<dim>::for_groups(const std::function<void(std::size_t)> &body) const {
  const std::size_t n = particles.groups.size();
  if (threads <= 1 || n <= 1)
    for (std::size_t group = 0; group < n; ++group) body(group);
  else {
    // small pieces: at the end of the loop all threads wait for the last one
    const std::size_t grain = std::max<std::size_t>(1, n / (std::size_t(threads) * 64));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                      [&](const tbb::blocked_range<std::size_t> &r) {
                        for (std::size_t group = r.begin(); group < r.end(); ++group) body(group);
                      });
  }
}

template <int dim>
void ParticleSystem<dim>::advance(const double dt) {
  for (const auto &term : terms) term->advance(particles, dt);
}

template <int dim>
void ParticleSystem<dim>::prepare(const bool trial) {
  for (const auto &term : terms) term->prepare(particles, box, threads, trial);
}

template <int dim>
void ParticleSystem<dim>::accept() {
  for (const auto &term : terms) term->accept();
}

template <int dim>
void ParticleSystem<dim>::drift_of_group(const std::size_t group, const double dt) {
  for (const auto &term : terms) term->drift(particles, group, dt);
}

template <int dim>
void ParticleSystem<dim>::damp_group(const std::size_t group, const double dt) {
  for (const auto &term : terms) term->damp(particles, box, group, dt);
}

template <int dim>
void ParticleSystem<dim>::forces_of_group(const std::size_t group) {
  const Group &g = particles.groups[group];
  for (int d = 0; d < dim; ++d)
    std::fill(particles.f[d].begin() + g.begin, particles.f[d].begin() + g.end, 0.);
  for (const auto &term : terms) term->add_forces(particles, box, group);
}

template <int dim>
void ParticleSystem<dim>::forces_of_group(const std::size_t group, const Pace pace) {
  const Group &g = particles.groups[group];
  for (int d = 0; d < dim; ++d)
    std::fill(particles.f[d].begin() + g.begin, particles.f[d].begin() + g.end, 0.);
  for (const auto &term : terms)
    if (pace == Pace::all || term->fast() == (pace == Pace::fast)) term->add_forces(particles, box, group);
}

template <int dim>
void ParticleSystem<dim>::compute_forces(const bool trial) {
  prepare(trial);
  const std::size_t n = particles.groups.size();
  if (particles.size() >= 8 * n) return for_groups([this](std::size_t group) { forces_of_group(group); });
  for_chunks(threads, Chunks(n), [this](std::size_t begin, std::size_t end) {
    for (auto &f : particles.f)
      std::fill(f.begin() + particles.groups[begin].begin, f.begin() + particles.groups[end - 1].end, 0.);
    for (const auto &term : terms) term->add_forces_of(particles, box, begin, end);
  });
}

template <int dim>
void ParticleSystem<dim>::collect(MotionMatrix &matrix, const double h) {
  for (const auto &term : terms) term->collect(matrix, particles, h);
}

template <int dim>
std::vector<MovedBodies<dim> *> ParticleSystem<dim>::moved_bodies() const {
  std::vector<MovedBodies<dim> *> all;
  for (const auto &term : terms)
    if (MovedBodies<dim> *bodies = term->moved_bodies()) all.push_back(bodies);
  return all;
}

template <int dim>
void ParticleSystem<dim>::gather(const Rearrangement &places) {
  for (const auto &term : terms) term->gather(places);
}

template <int dim>
double ParticleSystem<dim>::potential_energy() const {
  double total = 0.;
  for (std::size_t group = 0; group < particles.groups.size(); ++group)
    for (const auto &term : terms) total += term->energy(particles, box, group);
  return total;
}

template <int dim>
Energies ParticleSystem<dim>::energies() const {
  energy_of.assign(particles.groups.size(), {});
  for_groups([this](const std::size_t group) {
    for (const auto &term : terms) {
      const double one = term->energy(particles, box, group);
      energy_of[group].sum += one;
      energy_of[group].size += std::abs(one);
    }
  });
  Energies total;
  for (const Energies &one : energy_of) {
    total.sum += one.sum;
    total.size += one.size;
  }
  return total;
}

template <int dim>
double ParticleSystem<dim>::active_work(const double h) const {
  double total = 0.;
  for (std::size_t group = 0; group < particles.groups.size(); ++group)
    for (const auto &term : terms) total += term->active_work(particles, box, group, h);
  return total;
}

template <int dim>
bool ParticleSystem<dim>::random_forces(const std::vector<double> &medium, const double h,
                                        const std::uint64_t step) {
  if (std::none_of(terms.begin(), terms.end(), [](const auto &term) { return term->acts_at_random(); }))
    return false;
  std::vector<double> gamma = medium;
  for (const auto &term : terms) term->add_friction(particles, gamma);
  for (auto &f : particles.f) std::fill(f.begin(), f.end(), 0.);
  for (const auto &term : terms) term->add_random_forces(particles, gamma, h, step);
  return true;
}

template <int dim>
double ParticleSystem<dim>::heat() const {
  double total = 0.;
  for (const auto &term : terms) total += term->heat();
  return total;
}

template <int dim>
double ParticleSystem<dim>::kinetic_energy() const {
  double total = 0.;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.inverse_mass[i] > 0.)
      for (int d = 0; d < dim; ++d)
        total += 0.5 * particles.v[d][i] * particles.v[d][i] / particles.inverse_mass[i];
  return total;
}

template <int dim>
Vector<dim> ParticleSystem<dim>::momentum() const {
  Vector<dim> total = Vector<dim>::Zero();
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.inverse_mass[i] > 0.)
      for (int d = 0; d < dim; ++d) total[d] += particles.v[d][i] / particles.inverse_mass[i];
  return total;
}

template <int dim>
Tensor2<dim> ParticleSystem<dim>::virial() const {
  Tensor2<dim> total = Tensor2<dim>::Zero();
  for (std::size_t group = 0; group < particles.groups.size(); ++group) {
    const Group &g = particles.groups[group];
    Tensor2<dim> own = Tensor2<dim>::Zero();
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) {
        double sum = 0.;
        for (std::uint32_t i = g.begin; i < g.end; ++i) sum += particles.f[a][i] * particles.x[b][i];
        own(a, b) -= sum;
      }
    for (const auto &term : terms)
      own += term->image_virial(particles, box, group) + term->damping_virial(particles, group);
    total += own;
  }
  return total;
}

template <int dim>
double ParticleSystem<dim>::stable_time_step(const Pace pace) const {
  Rates total;
  for (const auto &term : terms) {
    if (pace != Pace::all && term->fast() != (pace == Pace::fast)) continue;
    const Rates own = term->rates(particles);
    total.wall += own.wall;
    total.fluid += own.fluid;
  }
  return std::min(total.wall.stable_time_step(), total.fluid.stable_time_step());
}

template <int dim>
std::vector<std::string> ParticleSystem<dim>::term_names() const {
  std::vector<std::string> names;
  for (const auto &term : terms) names.push_back(term->name());
  return names;
}

template <int dim>
void ParticleSystem<dim>::add_virials(std::vector<Tensor2<dim>> &virial) const {
  for (const auto &term : terms) term->add_virials(particles, virial);
}

template <int dim>
void ParticleSystem<dim>::archive_terms(Archive &a) {
  for (const auto &term : terms) term->archive(a, particles);
}

template <int dim>
void ParticleSystem<dim>::archive(Archive &a) {
  a.section("particles");
  for (int d = 0; d < dim; ++d) a.fixed(particles.x[d], particles.v[d], particles.f[d]);
  a.fixed(particles.inverse_mass);
  a(box.H, box.H_dot);
  const std::vector<double> inverse_mass = particles.inverse_mass;
  archive_terms(a);
  particles.inverse_mass = inverse_mass;  // a term's masses must not free a clamped particle
}

template class ParticleSystem<2>;
template class ParticleSystem<3>;
}  // namespace turgor
