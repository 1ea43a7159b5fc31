// dP/dF of the walls and the fluid's pressure alone: an answer's tangent without that of the viscous stress
// of the affine flow (affine_flow.h), where that is what the RVE's viscous stress is.
#pragma once

#include "rve/affine_flow.h"
#include "rve/rve.h"

namespace turgor {
/// Pa; the answer is one with tangent, at its trial state's F and F_dot.
inline Tensor4<2> elastic_tangent(const Rve<2> &rve, const RveAnswer<2> &answer) {
  const double mu = rve.flow_viscosity();
  if (!(mu > 0.)) return answer.tangent;
  return answer.tangent - AffineFlow<2>(mu, answer.trial.F, answer.trial.F_dot).tangent();
}
}  // namespace turgor
