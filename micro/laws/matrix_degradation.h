// How fast a cell degrades the matrix around it (thesis Eq. 6.1, 6.2, corrected: doc/equations.md): the share
// f of a material point that is intact falls, to no less than 0, by
//
//   df/dt = -(1/tau) exp(-(d - R)/decay)     d: distance from the cell's centre, within the cut-off and the
//                                            angle about the direction in which the cell is driven
//   S follows f                              dS/dt = (df/dt) S/f: Eq. 6.1 while f = 1, and no stress is left
//                                            in what is degraded wholly
//
// The shear modulus is f G, so the trail does not turn solid again.
#pragma once

#include "micro/geometry/tensor.h"

#include <algorithm>
#include <cmath>

namespace turgor {
struct MatrixDegradation {
  double rate = 0.;           ///< 1/s, 1/tau
  double radius = 0.;         ///< m, R
  double decay = 0.;          ///< m; thesis: R/4
  double cutoff = 0.;         ///< m, from the centre
  double least_cosine = -1.;  ///< of the angle with the direction

  /// 1/s; apart: m, from the cell's centre; direction: of unit length.
  template <int dim>
  double at(const Vector<dim> &apart, const Vector<dim> &direction) const {
    const double d = apart.norm();
    if (d > cutoff || apart.dot(direction) < least_cosine * d) return 0.;
    return rate * std::exp(-(d - radius) / decay);
  }

  /// f after h (s).
  static double after(const double intact, const double rate_here, const double h) {
    return std::max(0., intact - h * rate_here);
  }
};
}  // namespace turgor
