// dP/dF of the walls and the fluid's pressure alone: an answer's tangent without that of the viscous stress
// of the affine flow (affine_flow.h), where that is what the RVE's viscous stress is: all of it in cells
// without air between them, else the share of the cells, which changes with F too.
#pragma once

#include "rve/affine_flow.h"
#include "rve/rve.h"

namespace turgor {
/// Pa; the answer is one with tangent, at its trial state's F and F_dot.
inline Tensor4<2> elastic_tangent(const Rve<2> &rve, const RveAnswer<2> &answer) {
  const double mu = rve.flow_viscosity();
  if (!(mu > 0.)) return answer.tangent;
  const AffineFlow<2> flow(mu, answer.trial.F, answer.trial.F_dot);
  Tensor4<2> result = answer.tangent - (1. - answer.diagnostics.air) * flow.tangent();
  const Tensor2<2> full = flow.P();  // of cells without air between them
  for (int k = 0; k < 4; ++k)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        result(2 * a + b, k) += answer.diagnostics.air_slope[std::size_t(k)] * full(a, b);
  return result;
}
}  // namespace turgor
