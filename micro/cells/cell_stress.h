// Virial stress of single cells (thesis Eq. 2.13, 2.14, C.4 corrected): of cell i in its own volume
//
//   sigma_i = 1/V_i sum_j f_ij (x) r_ij,  p_i = -tr(sigma_i)/3,
//
// f_ij the force on i from j, r_ij from the centre of i to the contact plane, |r_ij| = (d + R_i - R_j)/2.
// Contacts with surroundings add theirs (Term::add_virials). Principal directions are the eigenvectors of
// sigma_i.
//
// Out: virial V_i sigma_i (N m) of all cells, after add_forces of the contacts at the same positions.
#pragma once

#include "run/parallel.h"
#include "run/written_anew.h"
#include "micro/geometry/tensor.h"
#include "micro/terms/sphere_contacts.h"

#include <vector>

namespace turgor {
inline void cell_virials(const Particles<3> &particles, const SphereContacts &contacts,
                         const unsigned int threads, std::vector<Tensor2<3>> &virial) {
  const std::vector<double> &radius = particles.field("radius");
  const PairList<3> &list = contacts.list();
  resize_anew(virial, particles.size());
  for_chunks(threads, Chunks(particles.size()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Tensor2<3> sum = Tensor2<3>::Zero();
      for (std::uint32_t k = list.first()[i]; k < list.first()[i + 1]; ++k) {
        const PairContact &c = contacts.contacts()[list.own()[k]];
        if (c.force == 0.) continue;
        const Vector<3> e(c.e[0], c.e[1], c.e[2]);
        sum -= (c.force * 0.5 * (c.distance + radius[i] - radius[list.other()[k]])) * (e * e.transpose());
      }
      virial[i] = sum;
    }
  });
}
}  // namespace turgor
