// The thesis's integrator (3.4.3): explicit Dormand-Prince 5(4) with error control, by SUNDIALS ARKStep.
//
//   y = (u, v) of the free nodes,   y' = (v, a(t, u, v))
//
// Six law calls a step: the last stage is the accepted state, its stress is committed and starts the next
// step. Every step is started afresh from (t, y, a) with the step size carried over and a controller without
// memory (I), so a loaded run goes on with the same bits whenever it was saved.
//
// The step never exceeds the CFL fraction of the stability limit, or the noise of RVE stresses makes error
// control collapse: |R(i w)| <= 1 up to w = 0.997; with at least 5 % damping of the fastest mode w = 2.0;
// damping alone c dt <= 3.3. A failed point halves the step, as in central_differences.h.
//
// The C interface, not deal.II's wrapper: that ignores return codes in release builds.
#pragma once

#include "macro/integrator.h"

#include <exception>
#include <string>

namespace turgor {
template <int dim>
class DormandPrince : public Integrator<dim> {
 public:
  DormandPrince(TissueOperator<dim> &op, const TissueParameters<dim> &parameters);
  ~DormandPrince() override;

  void step(double limit) override;
  double stable_step() const override;
  void archive(Archive &a) override;

  /// Called by ARKStep: 0 done, 1 recoverable, -1 not.
  int right_hand_side(double t, const double *y, double *y_dot) noexcept;

 private:
  struct Sundials;

  double first_try(double limit) const override;
  bool take_result(double reached);  // of ARKStep at that time, s; false: a point failed there

  std::unique_ptr<Sundials> sundials;
  std::vector<std::size_t> free_entries;
  std::vector<double> u, v, a;  // of the last right-hand side
  double next_step = 0.;        // s, carried over; 0: none yet
  bool point_failed = false;    // in the running step
  TissueFailure last_failure;
  std::exception_ptr thrown;  // held back while C code is on the stack
};
}  // namespace turgor
