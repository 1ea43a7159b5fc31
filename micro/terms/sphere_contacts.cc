#include "micro/terms/sphere_contacts.h"

#include "run/archive.h"
#include "run/parallel.h"
#include "micro/solve/step_too_long.h"
#include "run/number_text.h"
#include "micro/laws/overlap_energy.h"
#include "micro/solve/motion_matrix.h"
#include "micro/terms/sphere_links.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace turgor
{
SphereContacts::SphereContacts(const ContactLaw &law_, const double skin, std::optional<LocalStiffness> stiffness_,
                               const CompressionOf compression_)
  : law(law_)
  , stiffness(std::move(stiffness_))
  , compression(compression_)
  , pairs(skin)
{}

std::string SphereContacts::name(const ContactLaw &law)
{
  return name_of(law) + "_contact";
}

void SphereContacts::pack(const Particles<3> &particles, const unsigned int threads)
{
  const std::vector<double> &radius = particles.field("radius"), &modulus = particles.field("modulus");
  const std::size_t n = radius.size();
  const Chunks chunks(n, 2048);
  cells.resize(n);
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cells[i] = {{particles.x[0][i], particles.x[1][i], particles.x[2][i]}, radius[i], modulus[i]};
  });
  if (!stiffness)
    return;
  const double *volume = particles.has("reference_volume") ? particles.field("reference_volume").data() : nullptr;
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cells[i].reference = volume ? std::cbrt(volume[i] * (0.75 / std::numbers::pi)) : cells[i].radius;
  });
  if (compression == CompressionOf::contact)
    return;
  const auto &first = pairs.first(), &other = pairs.other();
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      {
        Cell &own = cells[i];
        double sum = 0., count = 0.;
        for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
          {
            const Cell &c = cells[other[k]];
            const double dx = c.x[0] - own.x[0], dy = c.x[1] - own.x[1], dz = c.x[2] - own.x[2];
            const double r2 = dx * dx + dy * dy + dz * dz, reach = c.radius + own.radius;
            if (r2 < reach * reach)
              {
                sum += 1. - std::sqrt(r2) / (c.reference + own.reference);
                count += 1.;
              }
          }
        if (count > 0.)
          {
            const LocalStiffness::Value g = (*stiffness)(sum / count);
            own.slope = own.modulus * g.slope; // modulus: read by no other cell's sum
            own.modulus *= g.factor;
          }
      }
  });
}

template <class Law>
void SphereContacts::compute_pairs(const Law &one, const unsigned int threads, const bool trial)
{
  const std::vector<Pair> &list = pairs.pairs();
  const bool each = stiffness && compression == CompressionOf::contact;
  std::atomic<std::size_t> coincide{list.size()};
  for_chunks(threads, Chunks(list.size(), 2048), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      {
        const Cell &i = cells[list[p].i], &j = cells[list[p].j];
        PairContact &c = contact[p];
        const double dx = j.x[0] - i.x[0], dy = j.x[1] - i.x[1], dz = j.x[2] - i.x[2], r2 = dx * dx + dy * dy + dz * dz;
        const double reach = i.radius + j.radius;
        bool now = r2 < reach * reach;
        double d = 0., R = 0., E = 0.;
        LocalStiffness::Value g;
        if (now || (Law::has_history && touching[p]))
          {
            d = std::sqrt(r2);
            R = i.radius * j.radius / reach;
            E = in_series(i.modulus, j.modulus);
            if (each)
              {
                g = (*stiffness)(1. - d / (i.reference + j.reference));
                E *= g.factor;
              }
            now = one.touching(R, E, reach - d, touching[p]);
          }
        if (Law::has_history && !trial)
          touching[p] = now;
        if (!now)
          {
            if (c.distance != 0.)
              c = PairContact();
            continue;
          }
        if (!(d > 0.))
          {
            coincide = p;
            continue;
          }
        const SphereContact s = one(R, E, reach - d);
        const double id = 1. / d;
        c = {{dx * id, dy * id, dz * id}, s.force, s.stiffness, s.area, s.energy, d};
        if (each && s.force > 0.)
          c.stiffness += s.force * g.slope / (g.factor * (i.reference + j.reference));
        else if (stiffness && s.force > 0.)
          { // d(1/E) = sum of d(1/E_i): dE = E^2 (dE_i/E_i^2 + dE_j/E_j^2)
            const double a = E / i.modulus, b = E / j.modulus;
            c.stiffness += s.force / E * (a * a * i.slope + b * b * j.slope) / (i.reference + j.reference);
          }
      }
  });
  if (coincide < list.size())
    throw StepTooLong("the centres of cells " + number_text(list[coincide].i) + " and "
                      + number_text(list[coincide].j)
                      + " coincide, so the direction of their contact is not defined: take smaller steps.");
}

void SphereContacts::declare(Particles<3> &particles)
{
  for (const char *const field : {"radius", "modulus"})
    particles.declare(field);
}

void SphereContacts::prepare(const Particles<3> &particles, const Box<3> &, const unsigned int threads, const bool trial)
{
  links.clear();
  const std::vector<double> &radius = particles.field("radius");
  if (pairs.stale(particles, radius, threads))
    {
      if (!std::visit([](const auto &one) { return one.has_history; }, law))
        touching.clear();
      pairs.build(particles, radius, touching, threads);
      contact.assign(pairs.pairs().size(), PairContact());
    }
  pack(particles, threads);
  contact.resize(pairs.pairs().size());
  std::visit([&](const auto &one) { compute_pairs(one, threads, trial); }, law);
}

void SphereContacts::accept()
{
  if (std::visit([](const auto &one) { return one.has_history; }, law))
    for (std::size_t p = 0; p < contact.size(); ++p)
      touching[p] = contact[p].distance != 0.;
}

void SphereContacts::gather_forces(Particles<3> &particles, const std::size_t begin, const std::size_t end) const
{
  const auto &first = pairs.first(), &own = pairs.own(), &other = pairs.other();
  for (std::size_t i = begin; i < end; ++i)
    {
      double sum[3] = {0., 0., 0.};
      for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
        {
          const PairContact &c = contact[own[k]];
          const double f = other[k] > i ? -c.force : c.force;
          for (int d = 0; d < 3; ++d)
            sum[d] += f * c.e[d];
        }
      for (int d = 0; d < 3; ++d)
        particles.f[d][i] += sum[d];
    }
}

void SphereContacts::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group)
{
  gather_forces(particles, particles.groups[group].begin, particles.groups[group].end);
}

void SphereContacts::add_forces_of(Particles<3> &particles, const Box<3> &, const std::size_t begin, const std::size_t end)
{
  gather_forces(particles, particles.groups[begin].begin, particles.groups[end - 1].end);
}

void SphereContacts::add_forces(Particles<3> &particles, const unsigned int threads, const bool trial)
{
  prepare(particles, Box<3>(), threads, trial);
  for_chunks(threads, Chunks(particles.size()), [&](std::size_t begin, std::size_t end) { gather_forces(particles, begin, end); });
}

double SphereContacts::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const
{
  double total = 0.;
  for (std::uint32_t i = particles.groups[group].begin; i < particles.groups[group].end; ++i)
    for (std::uint32_t k = pairs.first()[i]; k < pairs.first()[i + 1]; ++k)
      if (pairs.other()[k] > i)
        total += contact[pairs.own()[k]].energy;
  return total;
}

void SphereContacts::collect(MotionMatrix &matrix, const Particles<3> &, const double h)
{
  PairFriction with_step = friction;
  with_step.step = h;
  if (with_step.none())
    return;
  links.push_back(std::make_unique<SphereLinks>(*this, with_step));
  matrix.add(*links.back());
}

double SphereContacts::energy() const
{
  double total = 0.;
  for (const PairContact &c : contact)
    total += c.energy;
  return total;
}

void SphereContacts::gather(const Rearrangement &places)
{
  if (!std::visit([](const auto &one) { return one.has_history; }, law))
    touching.assign(touching.size(), 0); // nothing to keep
  pairs.gather(places, touching);
  contact.clear();
}

double SphereContacts::pair_energy(const Sphere &i, const Sphere &j, const double distance) const
{
  const double R = in_series(i.radius, j.radius), E = in_series(i.modulus, j.modulus);
  const double reach = i.radius + j.radius, reference = i.reference + j.reference, delta = reach - distance;
  if (!(delta > 0.))
    return 0.;
  return std::visit(
    [&](const auto &one) {
      if (!stiffness || compression == CompressionOf::cell)
        return one(R, E, delta).energy;
      const auto modulus = [&](const double overlap) { return E * (*stiffness)(1. - (reach - overlap) / reference).factor; };
      const auto force = [&](const double overlap) { return one(R, modulus(overlap), overlap).force; };
      // g is constant up to `soft` and from `hard` on
      const double soft = std::clamp(reach - (1. - stiffness->first()) * reference, 0., delta),
                   hard = std::clamp(reach - (1. - stiffness->last()) * reference, soft, delta);
      return one(R, modulus(soft), soft).energy + overlap_energy(soft, hard, 4, force) + overlap_energy(hard, delta, 2, force);
    },
    law);
}

std::size_t SphereContacts::memory_bytes() const
{
  return pairs.memory_bytes() + sizeof(PairContact) * contact.capacity() + touching.capacity() + sizeof(Cell) * cells.capacity();
}

void SphereContacts::archive(Archive &a, Particles<3> &particles)
{
  const std::vector<Pair> &list = pairs.pairs();
  std::vector<Pair> held;
  for (std::size_t p = 0; p < list.size() && !a.loading(); ++p)
    if (touching[p])
      held.push_back(list[p]);
  a.section("contacts");
  a(held);
  if (a.loading())
    pairs.restore(std::move(held), particles.size(), touching);
}
} // namespace turgor
