// How stiff a tangent is at most for waves: the largest eigenvalue of its acoustic tensor.
//
//   A_ac(n) = sum_bd n_b dP_ab/dF_cd n_d,   result = max over n of the largest eigenvalue of A(n)
//
// In: dP/dF (Pa) or dP/dF_dot (Pa s), entry (2 a + b, 2 c + d). Out: the same unit.
//
//   const double bound = 1.2 * acoustic_bound(tangent);
#pragma once

#include "micro/geometry/tensor.h"

namespace turgor {
/// Directions every degree: the maximum is found to 2e-4 of itself.
double acoustic_bound(const Tensor4<2> &tangent);
}  // namespace turgor
