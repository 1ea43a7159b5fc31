// The static state of the tissue under its loads, by Newton's method: f_int(u) = f_ext, u = 0 at clamped
// nodes.
//
// Needs a law with tangents; F_bar's linearisation is consistent, so convergence is quadratic. The load is
// applied in one go and, if Newton does not converge, in smaller and smaller increments. Each converged
// increment is committed. Linear systems: linear_solver.h.
#pragma once

#include "macro/linear_solver.h"
#include "macro/tissue_operator.h"

#include <functional>
#include <vector>

namespace turgor {
struct StaticSettings {
  double tolerance = 1e-9;  ///< residual / largest external force norm
  unsigned int most_iterations = 25;
  unsigned int most_halvings = 8;  ///< of the load increment
  LinearSettings linear;
  std::function<void()>
      each_evaluation;  ///< called before each of all points; what it throws ends the search
};

template <int dim>
struct StaticAnswer {
  std::vector<double> u;        ///< m, [node][dim]
  unsigned int iterations = 0;  ///< all Newton iterations
  unsigned int increments = 0;
  std::vector<double> residuals;  ///< relative, of the last increment, one per iteration
  double round_off =
      0.;  ///< relative residual that rounding alone can make: below it, what no longer falls is accepted
};

/// Starts from u (m), e.g. zero. Throws TissueFailed if a point fails in every increment, std::runtime_error
/// if the law gives no tangents or Newton does not converge, and whatever settings.each_evaluation throws.
template <int dim>
StaticAnswer<dim> static_equilibrium(TissueOperator<dim> &op, const std::vector<double> &start,
                                     const StaticSettings &settings = StaticSettings());
}  // namespace turgor
