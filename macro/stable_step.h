// The largest stable step of the explicit integrators, found sharply: every superfluous step costs a batch of
// RVEs.
//
//   omega^2 = largest eigenvalue of M^-1 K,   c = largest eigenvalue of M^-1 C   (1/s^2, 1/s)
//
// K from the law's tangents at the committed state when it gives them (power iteration over the whole mesh,
// F_bar included, 1 % on top), but never more than the bound from K <= stiffness_bound * L; without
// tangents that bound itself. L: Laplacian of each displacement component. C <= viscosity_bound * L. The
// law's bounds are those of dP/dF at F = I; a tissue pressed to the stretch lambda is J/lambda^2 stiffer
// against the reference, and so much are both bounds raised. Tools (rigid_tools.h) add their largest kappa
// A/m: the sum of two largest eigenvalues is never below that of the sum. It counts four times, so that a
// node on its penalty swings in no less than twice the time it could: a contact that opens and closes near
// its limit of stability gains energy at every stroke (an undamped block between plates blew up within 700
// steps), at half of it hardly any.
//
// Bounds over what? x^T K x = sum_q w_q G_q : A_q : G_q with the gradients G_q = dF_bar_q that the points
// see, so that x^T K x <= a sum_q w_q |G_q|^2 <= a x^T L x, a the largest eigenvalue of A over all G: F_bar
// puts the projection of tr dF in the place of tr dF and makes sum w |G|^2 no larger. Of plane waves alone (G
// = a (x) n) the bound would be right for one A everywhere, held sides, exact sums and a G that is the
// gradient of a displacement: only then the integral of det G is zero, in which both differ. A free side, two
// materials or F_bar's own G leave some of it, and one free bilinear element that breathes, G = I, has the
// whole (tests/macro/test_stable_step.cc).
#pragma once

#include "macro/tissue_operator.h"

namespace turgor {
class Archive;

template <int dim>
class StableStep {
 public:
  explicit StableStep(TissueOperator<dim> &op);

  /// Finds omega anew at the committed (u, v): one law call with tangents, which is a probe (nothing is
  /// committed).
  void estimate(double time, const std::vector<double> &u, const std::vector<double> &v);

  /// F_bar of the committed state. Nothing to see without tools: elsewhere tissue is not pressed.
  void observe(const std::vector<dealii::Tensor<2, dim>> &F);

  /// 1/s: at the law's present bounds. Between estimates omega grows with the law's stiffness bound.
  double frequency() const;
  double damping() const;

  void archive(Archive &a);

 private:
  double power_iteration(const std::vector<double> &matrices, unsigned int components) const;

  TissueOperator<dim> &op;
  double laplacian;            // 1/s^2 per Pa: largest eigenvalue of M^-1 L
  double frequency2 = 0.;      // 1/s^2, from tangents; 0: none
  double compression = 1.;     // largest J/lambda^2 over the points, at least 1; follows from the state
  double stiffness_then = 0.;  // Pa, the law's bound at that estimate
};
}  // namespace turgor
