#include "micro/terms/sphere_contacts.h"

#include "run/archive.h"
#include "run/parallel.h"
#include "micro/laws/overlap_energy.h"
#include "micro/solve/motion_matrix.h"
#include "micro/terms/sphere_links.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
SphereContacts::SphereContacts(const ContactLaw &law_, const double skin,
                               std::optional<LocalStiffness> stiffness_, const CompressionOf compression_)
    : law(law_),
      stiffness(std::move(stiffness_)),
      compression(compression_),
      all(std::make_shared<ContactList<3>>(
          skin, std::visit([](const auto &one) { return bool(one.has_history); }, law))),
      pairs(all->pairs()),
      touching(all->touching) {}

std::string SphereContacts::name(const ContactLaw &law) { return name_of(law) + "_contact"; }

void SphereContacts::declare(Particles<3> &particles) {
  for (const char *const field : {"radius", "modulus"}) particles.declare(field);
}

void SphereContacts::accept() {
  if (std::visit([](const auto &one) { return one.has_history; }, law))
    for (std::size_t p = 0; p < contact.size(); ++p) touching[p] = contact[p].distance != 0.;
}

void SphereContacts::gather_forces(Particles<3> &particles, const std::size_t begin,
                                   const std::size_t end) const {
  const auto &first = pairs.first(), &own = pairs.own(), &other = pairs.other();
  for (std::size_t i = begin; i < end; ++i) {
    double sum[3] = {0., 0., 0.};
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
      const PairContact &c = contact[own[k]];
      const double f = other[k] > i ? -c.force : c.force;
      for (int d = 0; d < 3; ++d) sum[d] += f * c.e[d];
    }
    for (int d = 0; d < 3; ++d) particles.f[d][i] += sum[d];
  }
}

void SphereContacts::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  gather_forces(particles, particles.groups[group].begin, particles.groups[group].end);
}

void SphereContacts::add_forces_of(Particles<3> &particles, const Box<3> &, const std::size_t begin,
                                   const std::size_t end) {
  gather_forces(particles, particles.groups[begin].begin, particles.groups[end - 1].end);
}

void SphereContacts::add_forces(Particles<3> &particles, const unsigned int threads, const bool trial) {
  prepare(particles, Box<3>(), threads, trial);
  for_chunks(threads, Chunks(particles.size()),
             [&](std::size_t begin, std::size_t end) { gather_forces(particles, begin, end); });
}

double SphereContacts::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const {
  double total = 0.;
  for (std::uint32_t i = particles.groups[group].begin; i < particles.groups[group].end; ++i)
    for (std::uint32_t k = pairs.first()[i]; k < pairs.first()[i + 1]; ++k)
      if (pairs.other()[k] > i) total += contact[pairs.own()[k]].energy;
  return total;
}

void SphereContacts::collect(MotionMatrix &matrix, const Particles<3> &, const double h) {
  PairFriction with_step = friction;
  with_step.step = h;
  if (with_step.none()) return;
  links.push_back(std::make_unique<SphereLinks>(*this, with_step));
  matrix.add(*links.back());
}

double SphereContacts::energy() const {
  double total = 0.;
  for (const PairContact &c : contact) total += c.energy;
  return total;
}

void SphereContacts::gather(const Rearrangement &places) {
  if (!std::visit([](const auto &one) { return one.has_history; }, law))
    touching.assign(touching.size(), 0);  // nothing to keep
  pairs.gather(places, touching);
  contact.clear();
}

double SphereContacts::pair_energy(const Sphere &i, const Sphere &j, const double distance) const {
  const double R = in_series(i.radius, j.radius), E = in_series(i.modulus, j.modulus);
  const double reach = i.radius + j.radius, reference = i.reference + j.reference, delta = reach - distance;
  if (!(delta > 0.)) return 0.;
  return std::visit(
      [&](const auto &one) {
        if (!stiffness || compression == CompressionOf::cell) return one(R, E, delta).energy;
        const auto modulus = [&](const double overlap) {
          return E * (*stiffness)(1. - (reach - overlap) / reference).factor;
        };
        const auto force = [&](const double overlap) { return one(R, modulus(overlap), overlap).force; };
        // g is constant up to `soft` and from `hard` on
        const double soft = std::clamp(reach - (1. - stiffness->first()) * reference, 0., delta),
                     hard = std::clamp(reach - (1. - stiffness->last()) * reference, soft, delta);
        return one(R, modulus(soft), soft).energy + overlap_energy(soft, hard, 4, force) +
               overlap_energy(hard, delta, 2, force);
      },
      law);
}

std::size_t SphereContacts::memory_bytes() const {
  return pairs.memory_bytes() + sizeof(PairContact) * contact.capacity() + touching.capacity() +
         sizeof(Cell) * cells.capacity();
}

void SphereContacts::archive(Archive &a, Particles<3> &particles) {
  const std::vector<Pair> &list = pairs.pairs();
  std::vector<Pair> held;
  for (std::size_t p = 0; p < list.size() && !a.loading(); ++p)
    if (touching[p]) held.push_back(list[p]);
  a.section("contacts");
  a(held);
  if (a.loading()) pairs.restore(std::move(held), particles.size(), touching);
}
}  // namespace turgor
