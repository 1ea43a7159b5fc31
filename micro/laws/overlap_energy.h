// Energy of a contact whose force is known as a function of the overlap alone:  U = integral of F over the
// overlap (thesis 2.5, C.9).
//
// In t = sqrt(overlap) the integrand 2 t F is smooth: Gauss' rule with three places in each piece. Pieces
// should begin and end where F has kinks (LocalStiffness::kinks).
//
// In: overlaps (m), F (N). Out: J.
#pragma once

#include <array>
#include <cmath>

namespace turgor {
template <class Force>
double overlap_energy(const double from, const double to, const int pieces, const Force &force) {
  constexpr std::array<double, 3> node{-0.7745966692414834, 0., 0.7745966692414834},
      weight{5. / 9., 8. / 9., 5. / 9.};
  const double first = std::sqrt(from), step = (std::sqrt(to) - first) / pieces;
  double sum = 0.;
  for (int p = 0; p < pieces; ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      const double t = first + step * (p + 0.5 + 0.5 * node[k]);
      sum += weight[k] * step * t * force(t * t);
    }
  return sum;
}
}  // namespace turgor
