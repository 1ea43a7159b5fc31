#include "micro/terms/sphere_contacts.h"

#include "micro/engine/binary.h"
#include "micro/engine/parallel.h"

#include <atomic>
#include <stdexcept>

namespace turgor
{
SphereContacts::SphereContacts(const ContactLaw &law_, const double skin)
  : law(law_)
  , pairs(skin)
{}

std::string SphereContacts::name(const ContactLaw &law)
{
  return std::holds_alternative<HertzContact>(law) ? "hertz_contact" :
         std::holds_alternative<JkrContact>(law)   ? "jkr_contact" :
                                                     "extended_hertz_contact";
}

template <class Law>
void SphereContacts::compute_pairs(const Law &one, const Particles<3> &particles, const unsigned int threads,
                                   const bool trial)
{
  const double *x = particles.x[0].data(), *y = particles.x[1].data(), *z = particles.x[2].data();
  const double *radius = particles.field("radius").data(), *modulus = particles.field("modulus").data();
  const std::vector<Pair> &list = pairs.pairs();
  std::atomic<std::size_t> coincide{list.size()};
  for_chunks(threads, Chunks(list.size(), 2048), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      {
        const auto [i, j] = list[p];
        PairContact &c = contact[p];
        const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i], r2 = dx * dx + dy * dy + dz * dz;
        const double reach = radius[i] + radius[j];
        if (!Law::has_history && !(r2 < reach * reach))
          {
            c = PairContact();
            if (!trial)
              touching[p] = 0;
            continue;
          }
        const double d = std::sqrt(r2), delta = reach - d;
        const double R = in_series(radius[i], radius[j]), E = in_series(modulus[i], modulus[j]);
        const bool now = one.touching(R, E, delta, touching[p]);
        if (!trial)
          touching[p] = now;
        if (!now)
          {
            c = PairContact();
            continue;
          }
        if (!(d > 0.))
          {
            coincide = p;
            continue;
          }
        const SphereContact s = one(R, E, delta);
        const double id = 1. / d;
        c = {{dx * id, dy * id, dz * id}, s.force, s.stiffness, s.area, s.energy, d};
      }
  });
  if (coincide < list.size())
    throw std::runtime_error("the centres of cells " + std::to_string(list[coincide].i) + " and "
                             + std::to_string(list[coincide].j)
                             + " coincide, so the direction of their contact is not defined: take smaller steps.");
}

void SphereContacts::add_forces(Particles<3> &particles, const unsigned int threads, const bool trial)
{
  const std::vector<double> &radius = particles.field("radius");
  if (pairs.stale(particles, radius))
    pairs.build(particles, radius, touching);
  contact.resize(pairs.pairs().size());
  std::visit([&](const auto &one) { compute_pairs(one, particles, threads, trial); }, law);
  const auto &first = pairs.first(), &own = pairs.own();
  const std::vector<Pair> &list = pairs.pairs();
  for_chunks(threads, Chunks(radius.size()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      {
        double sum[3] = {0., 0., 0.};
        for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
          {
            const PairContact &c = contact[own[k]];
            const double f = list[own[k]].i == i ? -c.force : c.force;
            for (int d = 0; d < 3; ++d)
              sum[d] += f * c.e[d];
          }
        for (int d = 0; d < 3; ++d)
          particles.f[d][i] += sum[d];
      }
  });
}

double SphereContacts::energy() const
{
  double total = 0.;
  for (const PairContact &c : contact)
    total += c.energy;
  return total;
}

double SphereContacts::pressure(const Particles<3> &particles, const std::uint32_t i, const double V) const
{
  const std::vector<double> &radius = particles.field("radius");
  double trace = 0.; // f_ij . r_ij, f on i
  for (std::uint32_t k = pairs.first()[i]; k < pairs.first()[i + 1]; ++k)
    {
      const PairContact &c = contact[pairs.own()[k]];
      trace -= c.force * 0.5 * (c.distance + radius[i] - radius[pairs.other()[k]]);
    }
  return -trace / (3. * V);
}

void SphereContacts::gather(const std::vector<std::uint32_t> &source)
{
  if (!std::visit([](const auto &one) { return one.has_history; }, law))
    touching.assign(touching.size(), 0); // nothing to keep
  pairs.gather(source, touching);
  contact.clear();
}

double SphereContacts::pair_energy(const double radius_i, const double radius_j, const double modulus_i,
                                   const double modulus_j, const double distance) const
{
  const double R = in_series(radius_i, radius_j), E = in_series(modulus_i, modulus_j);
  const double delta = radius_i + radius_j - distance;
  return std::visit(
    [&](const auto &one) { return one.touching(R, E, delta, false) ? one(R, E, delta).energy : 0.; }, law);
}

void SphereContacts::save(std::ostream &out) const
{
  const std::vector<Pair> &list = pairs.pairs();
  std::vector<Pair> held;
  for (std::size_t p = 0; p < list.size(); ++p)
    if (touching[p])
      held.push_back(list[p]);
  write_binary(out, held);
}

void SphereContacts::load(std::istream &in, const Particles<3> &particles)
{
  std::vector<Pair> held;
  read_binary(in, held);
  pairs.restore(std::move(held), particles.size(), touching);
}
} // namespace turgor
