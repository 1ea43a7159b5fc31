#include "micro/processes/cell_division.h"

#include "micro/laws/counter_random.h"
#include "micro/terms/wall_contact.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace turgor {
Vector<3> CellDivision::choose(const std::uint64_t mother_id, const Tensor2<3> &stress) const {
  if (direction == DivisionDirection::given) return axis.normalized();
  if (direction == DivisionDirection::least_stress && stress.norm() > 0.)
    return Eigen::SelfAdjointEigenSolver<Tensor2<3>>(0.5 * (stress + stress.transpose()))
        .eigenvectors()
        .col(2);
  const std::uint64_t stream = mix_bits(seed ^ 0x646976697369ull);
  const double turn = 2. * std::numbers::pi * random_uniform(stream, 2 * mother_id);
  const double z = direction == DivisionDirection::random_in_plane
                       ? 0.
                       : 2. * random_uniform(stream, 2 * mother_id + 1) - 1.;
  const double across = std::sqrt(1. - z * z);
  return {across * std::cos(turn), across * std::sin(turn), z};
}

double CellDivision::half_distance(const CellPopulation &cells, const SphereContacts &contacts,
                                   const PairList<3> &near, const Surroundings &surroundings,
                                   const std::uint32_t mother, const Vector<3> &along,
                                   const double radius) const {
  const Particles<3> &p = cells.particles;
  const std::vector<double> &R = p.field("radius");
  const ReferenceRadius reference(p);
  const double nearest = R[mother] - radius, farthest = radius;
  if (!least_energy) return nearest;
  const Vector<3> centre = p.position(mother);
  const SphereContacts::Sphere daughter{radius, reference(mother) * std::cbrt(0.5), contacts.modulus(mother)};
  const auto energy = [&](const double s) {
    double sum = contacts.pair_energy(daughter, daughter, 2. * s);
    for (const double side : {-s, s})
      sum += surroundings.energy_of(centre + side * along, radius, daughter.reference,
                                    p.field("modulus")[mother]);
    for (std::uint32_t k = near.first()[mother]; k < near.first()[mother + 1]; ++k) {
      const std::uint32_t j = near.other()[k];
      const Vector<3> to = p.position(j) - centre;
      const SphereContacts::Sphere neighbour{R[j], reference(j), contacts.modulus(j)};
      for (const double side : {-s, s})
        sum += contacts.pair_energy(daughter, neighbour, (to - side * along).norm());
    }
    return sum;
  };
  // The least of a few places, then the golden section about it.
  constexpr int places = 8;
  const double spacing = (farthest - nearest) / places;
  int best = 0;
  double least = energy(nearest);
  for (int k = 1; k <= places; ++k)
    if (const double e = energy(nearest + k * spacing); e < least) {
      least = e;
      best = k;
    }
  double low = nearest + std::max(0, best - 1) * spacing,
         high = nearest + std::min(places, best + 1) * spacing;
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low), at_a = energy(a),
         at_b = energy(b);
  while (high - low > 1e-3 * radius)
    if (at_a < at_b || !std::isfinite(at_b))  // towards the mother, away from what is forbidden
    {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = energy(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = energy(b);
    }
  return 0.5 * (low + high);
}
}  // namespace turgor
