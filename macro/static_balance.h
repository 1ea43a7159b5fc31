// The balance of the nodal forces of a tissue at rest, and its tangent:
//
//   r(u; s) = s f_ext + f_tools(t, u) - f_int(u),   r = 0 at clamped nodes,   K = -dr/du
//
// F-bar and the contact of the tools are linearised consistently, so Newton's method on it is quadratic. s:
// the share of the dead loads that is on; t: s, time, which moves tools and lets broken cells leak. The
// velocity is zero: viscous stress has no part in it.
//
// A piece between frictionless tools is held by nothing along them: there the middle of its foot is held by a
// spring. Between plates forces along them cancel, so the spring stays without force; under a cylinder it
// keeps the piece from sliding out from below.
#pragma once

#include "macro/linear_solver.h"
#include "macro/tissue_operator.h"

#include <vector>

namespace turgor {
/// Where on the path of loading.
struct LoadPlace {
  double time = 0.;          ///< s
  double since_commit = 0.;  ///< s, since the last commit of the law
  double share = 1.;         ///< of the dead loads
};

template <int dim>
class StaticBalance {
 public:
  /// The operator must outlive it.
  StaticBalance(TissueOperator<dim> &op, const LinearSettings &settings);

  /// False: a point failed (op.failure()); then nothing below may be used.
  bool evaluate(const std::vector<double> &u, const LoadPlace &place);
  const std::vector<double> &residual() const { return r; }  ///< N
  double residual_norm() const;                              ///< N

  /// N, norm of what is in balance: dead loads, tools and what holds the clamped nodes.
  double force_norm() const;
  /// N, sum of the forces of the clamped nodes' holder on the tissue.
  const dealii::Tensor<1, dim> &held() const { return holding; }
  /// N, norm of all dead loads; 0: none.
  double load_norm() const { return all_of_load; }
  const std::vector<double> &load() const { return dead; }  ///< N, zero at clamped nodes

  /// J, at the last u: stored, spent and in contact.
  double energy() const;
  /// J, that a drag (as of linearise) takes along a move (m), the whole of it at its last speed.
  double taken_by_drag(double drag, const std::vector<double> &move) const;

  /// N: what the rounding of F = I + grad u makes of forces, as a norm over the free nodes.
  double round_off() const;

  /// The tangent of the last evaluate(). drag: added to it, in units of what a node of the stiffest elements
  /// feels (0: none).
  void linearise(double drag = 0.);
  /// With that tangent: m from N.
  std::vector<double> solve(const std::vector<double> &right) { return linear.solve(right); }

  /// N per unit of share and N/m of tool travel: how r changes at the last u.
  std::vector<double> by_travel() const;

  TissueOperator<dim> &forces() { return op; }
  const LinearStatistics &statistics() const { return linear.statistics(); }

 private:
  bool symmetric() const;

  TissueOperator<dim> &op;
  LinearSolver<dim> linear;
  std::vector<double> dead, r, last_u;
  std::vector<double> feel;  ///< N/m, per node: stiffness bound * volume / (size of an element)^2
  double all_of_load = 0., held_and_pressed = 0.;
  dealii::Tensor<1, dim> holding;
  LoadPlace last;
  bool slides = false;  ///< nothing holds it along the plates
  unsigned int pinned = 0;
};
}  // namespace turgor
