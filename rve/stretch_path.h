// The way from one deformation gradient to another: the rotation at once, then the stretch in equal steps.
//
//   F_to F_from^-1 = V R (polar),  V = sum_a lambda_a n_a (x) n_a
//   F(s) = V^s R F_from,  V^s = sum_a lambda_a^s n_a (x) n_a,  0 < s <= 1
//
// A rigid rotation costs no cell anything, so it needs no steps, and the way turns with F_to: F_to -> Q F_to
// gives F(s) -> Q F(s). det F(s) goes geometrically from det F_from to det F_to: always positive, and
// constant when both are equal (a straight line between the two would inflate a sheared or stretched cell on
// its way).
#pragma once

#include "micro/geometry/tensor.h"

namespace turgor {
class StretchPath {
 public:
  /// Both determinants must be positive.
  StretchPath(const Tensor2<2> &from, const Tensor2<2> &to);

  /// Largest |ln lambda|: how much the change stretches or shortens any line of the material; about the norm
  /// of U - I where that is small, and the same for a change and its inverse. Not finite where no path can be
  /// found.
  double length() const { return strain.cwiseAbs().maxCoeff(); }

  Tensor2<2> at(double s) const;

 private:
  Vector<2> strain;         ///< ln lambda
  Tensor2<2> axes, turned;  ///< columns n_a; R F_from
};
}  // namespace turgor
