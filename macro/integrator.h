// What both time integrators share: the state of the tissue at a committed time, and one step from it.
#pragma once

#include "macro/stable_step.h"
#include "macro/tissue_operator.h"

#include <memory>
#include <optional>
#include <vector>

namespace turgor {
class Archive;

template <int dim>
struct TissueState {
  double time = 0.;             ///< s
  std::vector<double> u, v, a;  ///< m, m/s, m/s^2; [node][dim]; a: central_differences without the tools'
  std::vector<dealii::Tensor<2, dim>> F, P;     ///< F_bar and Pa, at all quadrature points
  std::vector<dealii::Tensor<2, dim>> viscous;  ///< Pa, its part in P; empty if the law does not know
  std::vector<double> energy;                   ///< J/m^3 per point; empty if the law gives none
  ToolReading tool;                             ///< N, J; support: of the clamp or the plate below
  double tool_work = 0.;                        ///< J, done by the tool since rest
  double heating = 0.;                          ///< W, that F does not show
  double heat = 0.;   ///< J, by viscosity since rest; signalling NaN if the law does not know
  double spent = 0.;  ///< J, lost since rest by what has no rate: flow, breaking
  double lent = 0.;   ///< J, by the steps (energy_balance.h)

  void archive(Archive &a);
};

struct StepCounters {
  unsigned long steps = 0;     ///< accepted
  unsigned long rejected = 0;  ///< by error control or a failed point
  unsigned long failures = 0;  ///< batches in which a point failed
};

template <int dim>
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Stress and acceleration of the state at rest at t = 0; throws TissueFailed.
  void start();

  /// Puts the tissue into another state (m, m/s) at its present time, e.g. the static one, and commits the
  /// law there; throws TissueFailed.
  void place(const std::vector<double> &u, const std::vector<double> &v);

  /// One accepted step, committed, not beyond `limit` (s). Throws TissueFailed; the state is then as before.
  virtual void step(double limit) = 0;

  TissueState<dim> state;
  StepCounters counters;
  double last_step = 0.;  ///< s

  /// The step (s) that would be tried now, apart from the limit.
  virtual double stable_step() const = 0;

  /// Where (s) a step under this limit would lead that is accepted as it is tried. Finds the stable step anew
  /// when that is due.
  double upcoming(double limit);

  /// Everything the coming steps depend on, the law excepted. The mesh and the parameters must be the same.
  virtual void archive(Archive &a);

 protected:
  Integrator(TissueOperator<dim> &op, const TissueParameters<dim> &parameters);

  /// The operator's last answer, reached at the given state, becomes the state. tools: of the step; where
  /// they are not given, their forces at its ends and the trapezoidal rule.
  void accept(double time, const std::optional<ToolStep> &tools = {});
  /// state.a from the operator's last answer.
  virtual void accelerate() { op.acceleration(state.a); }
  void add_heat(double time);
  /// Finds the stable step anew when it is due.
  void refresh();
  /// The step (s) that is tried first under this limit; not beyond it.
  virtual double first_try(double limit) const = 0;

  TissueOperator<dim> &op;
  const TissueParameters<dim> parameters;
  StableStep<dim> stability;
  unsigned long since_estimate = 0;
};

/// By the name in the parameters.
template <int dim>
std::unique_ptr<Integrator<dim>> make_integrator(TissueOperator<dim> &op,
                                                 const TissueParameters<dim> &parameters);
}  // namespace turgor
