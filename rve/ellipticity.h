// How far a tangent is from losing ellipticity: the smallest eigenvalue of its acoustic tensor over all
// directions. Where it is negative a band of material slides (or opens) by itself: its width is that of one
// finite element, whatever the mesh.
//
//   A_ac(n) = 1/J sum_bd N_b dP_ab/dF_cd N_d,   N = F^T n, J = det F,   least over unit vectors n of the
//   smallest eigenvalue of A(n), with its vector m
//
// n is the normal of the band in the tissue as it is deformed, m the direction in which it moves. In: dP/dF
// (Pa), entry (2 a + b, 2 c + d), and F. Out: Pa, rad from x, in [0, pi).
//
//   const LeastAcoustic least(tangent, F);
#pragma once

#include "micro/geometry/tensor.h"

namespace turgor {
struct LeastAcoustic {
  /// Directions every degree, then golden sections about the best: 1e-8 rad, or the other of two that are
  /// alike to 1e-4 of their value.
  LeastAcoustic(const Tensor4<2> &tangent, const Tensor2<2> &F);

  double value;           ///< Pa
  double normal, motion;  ///< rad
};
}  // namespace turgor
