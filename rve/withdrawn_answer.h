// What every RVE does alike with what it cannot answer.
#pragma once

#include "rve/rve.h"

#include <cmath>
#include <stdexcept>

namespace turgor
{
/// Throws std::invalid_argument for what no RVE can be asked.
template <int dim>
void check_motion(const Tensor2<dim> &F, const Tensor2<dim> &F_dot)
{
  if (!F.allFinite() || !F_dot.allFinite() || !(F.determinant() > 0.))
    throw std::invalid_argument("An RVE needs a finite F with positive determinant and a finite F_dot.");
}

/// What did not converge has no number to build on, never NaN, and leaves the committed state.
template <int dim>
void withdraw(RveAnswer<dim> &answer, const RveState<dim> &committed)
{
  answer.sigma.setZero();
  answer.P.setZero();
  answer.viscous.setZero();
  answer.tangent.setZero();
  answer.rate_tangent.setZero();
  answer.energy = answer.heating = answer.pressure = 0.;
  answer.condition = {};
  answer.trial = committed;
  if (!std::isfinite(answer.diagnostics.residual))
    answer.diagnostics.residual = HUGE_VAL;
}
} // namespace turgor
