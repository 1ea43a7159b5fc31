// What the pairs of spheres that touch do to each other: cells packed, then each pair once.
#include "micro/terms/sphere_contacts.h"

#include "micro/solve/step_too_long.h"
#include "run/number_text.h"
#include "run/parallel.h"
#include "run/written_anew.h"

#include <algorithm>
#include <atomic>

namespace turgor {
void SphereContacts::pack(const Particles<3> &particles, const unsigned int threads) {
  const std::vector<double> &radius = particles.field("radius"), &modulus = particles.field("modulus");
  const std::size_t n = radius.size();
  const Chunks chunks(n, 2048);
  resize_anew(cells, n);
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cells[i] = {{particles.x[0][i], particles.x[1][i], particles.x[2][i]}, radius[i], modulus[i]};
  });
  if (!stiffness) return;
  const double *volume =
      particles.has("reference_volume") ? particles.field("reference_volume").data() : nullptr;
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cells[i].reference = volume ? std::cbrt(volume[i] * (0.75 / std::numbers::pi)) : cells[i].radius;
  });
  if (compression == CompressionOf::contact) return;
  const auto &first = pairs.first(), &other = pairs.other();
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Cell &own = cells[i];
      double sum = 0., count = 0.;
      for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
        const Cell &c = cells[other[k]];
        const double dx = c.x[0] - own.x[0], dy = c.x[1] - own.x[1], dz = c.x[2] - own.x[2];
        const double r2 = dx * dx + dy * dy + dz * dz, reach = c.radius + own.radius;
        if (r2 < reach * reach) {
          sum += 1. - std::sqrt(r2) / (c.reference + own.reference);
          count += 1.;
        }
      }
      if (count > 0.) {
        const LocalStiffness::Value g = (*stiffness)(sum / count);
        own.slope = own.modulus * g.slope;  // modulus: read by no other cell's sum
        own.modulus *= g.factor;
      }
    }
  });
}

/// A pair that touches, before its law.
struct SphereContacts::Touch {
  std::size_t pair;
  double way[3];  ///< from i to j
  double distance, R, E, overlap;
  LocalStiffness::Value g;  ///< of the pair, where the stiffness is
};

inline void SphereContacts::store(const Touch &t, const SphereContact &s) {
  const double id = 1. / t.distance;
  PairContact &c = contact[t.pair];
  c = {{t.way[0] * id, t.way[1] * id, t.way[2] * id}, s.force, s.stiffness, s.area, s.energy, t.distance};
  if (!stiffness ||
      !(s.by_modulus > 0.))  // what falls is left out of implicit steps, as all that is negative
    return;
  const Cell &i = cells[pairs.pairs()[t.pair].i], &j = cells[pairs.pairs()[t.pair].j];
  if (compression == CompressionOf::contact)
    c.stiffness += s.by_modulus * t.g.slope / (t.g.factor * (i.reference + j.reference));
  else {  // d(1/E) = sum of d(1/E_i): dE = E^2 (dE_i/E_i^2 + dE_j/E_j^2)
    const double a = t.E / i.modulus, b = t.E / j.modulus;
    c.stiffness += s.by_modulus / t.E * (a * a * i.slope + b * b * j.slope) / (i.reference + j.reference);
  }
}

/// Pairs whose law is worth it four at a time, which changes no bit (sphere_contact.h).
template <class Law>
void SphereContacts::compute_pairs(const Law &one, const unsigned int threads, const bool trial) {
  using lanes::Four;
  constexpr std::size_t width = requires { one(Four(), Four(), Four()); }
  ? 4 : 1;
  const std::vector<Pair> &list = pairs.pairs();
  const bool each = stiffness && compression == CompressionOf::contact;
  std::atomic<std::size_t> coincide{list.size()};
  for_chunks(threads, Chunks(list.size(), 2048), [&](std::size_t begin, std::size_t end) {
    Touch waiting[width];
    std::size_t count = 0;
    const auto evaluate = [&] {
      if constexpr (width > 1) {
        Four R, E, overlap;
        for (std::size_t k = 0; k < width; ++k) {  // the last few are filled up
          const Touch &t = waiting[std::min(k, count - 1)];
          R[k] = t.R;
          E[k] = t.E;
          overlap[k] = t.overlap;
        }
        const ContactOf<Four> four = one(R, E, overlap);
        for (std::size_t k = 0; k < count; ++k)
          store(waiting[k],
                {four.force[k], four.stiffness[k], four.area[k], four.energy[k], four.by_modulus[k]});
      }
      count = 0;
    };
    for (std::size_t p = begin; p < end; ++p) {
      const Cell &i = cells[list[p].i], &j = cells[list[p].j];
      const double dx = j.x[0] - i.x[0], dy = j.x[1] - i.x[1], dz = j.x[2] - i.x[2],
                   r2 = dx * dx + dy * dy + dz * dz;
      const double reach = i.radius + j.radius;
      bool now = r2 < reach * reach;
      Touch t;
      if (now || (Law::has_history && touching[p])) {
        t = {p, {dx, dy, dz}, std::sqrt(r2), i.radius * j.radius / reach, in_series(i.modulus, j.modulus), 0.,
             {}};
        t.overlap = reach - t.distance;
        if (each) {
          t.g = (*stiffness)(1. - t.distance / (i.reference + j.reference));
          t.E *= t.g.factor;
        }
        now = one.touching(t.R, t.E, t.overlap, touching[p]);
      }
      if (Law::has_history && !trial) touching[p] = now;
      if (!now) {
        if (contact[p].distance != 0.) contact[p] = PairContact();
      } else if (!(t.distance > 0.))
        coincide = p;
      else if constexpr (width == 1)
        store(t, one(t.R, t.E, t.overlap));
      else {
        waiting[count] = t;
        if (++count == width) evaluate();
      }
    }
    if (count > 0) evaluate();
  });
  if (coincide < list.size())
    throw StepTooLong("the centres of cells " + number_text(list[coincide].i) + " and " +
                      number_text(list[coincide].j) +
                      " coincide, so the direction of their contact is not defined: take smaller steps.");
}

void SphereContacts::prepare(const Particles<3> &particles, const Box<3> &, const unsigned int threads,
                             const bool trial) {
  links.clear();
  all->bring_up_to_date(particles, threads);
  pack(particles, threads);
  // What a pair of the list before has left is written over below, or is nought.
  resize_anew(contact, pairs.pairs().size());
  std::visit([&](const auto &one) { compute_pairs(one, threads, trial); }, law);
}
}  // namespace turgor
