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
#include <stdexcept>
#include <string>
#include <vector>

namespace turgor {
struct StaticSettings {
  double tolerance = 1e-9;  ///< residual / largest external force norm
  unsigned int most_iterations = 25;
  unsigned int most_halvings = 8;  ///< of the load increment
  LinearSettings linear;
  std::function<void()>
      each_evaluation;  ///< called before each of all points; what it throws ends the search
  /// Before each search: the share of the load that is carried, and by how much more is searched for.
  std::function<void(double, double)> each_search;
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

/// No increment of the load led on.
class NoStaticState : public std::runtime_error {
 public:
  NoStaticState(const std::string &sentence, double share_) : std::runtime_error(sentence), share(share_) {}
  const double share;  ///< of the load, that is carried
};

/// Starts from u (m), e.g. zero. Throws NoStaticState, std::runtime_error if the law gives no tangents, and
/// whatever the settings' functions throw.
template <int dim>
StaticAnswer<dim> static_equilibrium(TissueOperator<dim> &op, const std::vector<double> &start,
                                     const StaticSettings &settings = StaticSettings());
}  // namespace turgor
