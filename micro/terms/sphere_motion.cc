#include "micro/terms/sphere_motion.h"

#include "run/parallel.h"

#include <algorithm>

namespace turgor
{
namespace
{
/// So little is done to a cell here that a few thousand are worth no second thread.
Chunks cells_of(const std::size_t n) { return Chunks(n, 4096); }
} // namespace

SphereMotion::SphereMotion(SphereContacts &contacts_, Friction &friction_, const unsigned int threads_)
  : contacts(contacts_)
  , friction(friction_)
  , threads(threads_)
{}

void SphereMotion::forces(Particles<3> &particles, const bool trial)
{
  for_chunks(threads, cells_of(particles.size()), [&](std::size_t begin, std::size_t end) {
    for (auto &f : particles.f)
      std::fill(f.begin() + std::ptrdiff_t(begin), f.begin() + std::ptrdiff_t(end), 0.);
  });
  contacts.add_forces(particles, threads, trial);
  if (outer)
    outer(particles);
}

void SphereMotion::velocities(Particles<3> &particles, const double h)
{
  if (!(h > 0. && outer_stiffness))
    return friction.velocities(particles, contacts, gamma, h, threads);
  drag.assign(gamma.size(), 0.);
  outer_stiffness(particles, drag);
  for_chunks(threads, cells_of(gamma.size()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      drag[i] = gamma[i] + h * drag[i];
  });
  friction.velocities(particles, contacts, drag, h, threads);
}

void SphereMotion::again(Particles<3> &particles) { friction.velocities_again(particles, threads); }

bool SphereMotion::random_forces(Particles<3> &particles, const double h, const std::uint64_t step)
{
  if (random)
    random(particles, h, step);
  return bool(random);
}

double SphereMotion::length(const Particles<3> &particles) const
{
  const std::vector<double> &radius = particles.field("radius");
  std::vector<double> parts;
  const double sum = sum_chunks(threads, cells_of(radius.size()), parts, [&](std::size_t begin, std::size_t end) {
    double part = 0.;
    for (std::size_t i = begin; i < end; ++i)
      part += radius[i];
    return part;
  });
  return sum / double(std::max<std::size_t>(radius.size(), 1));
}
} // namespace turgor
