#include "macro/integrator.h"

#include "run/archive.h"
#include "macro/central_differences.h"
#include "macro/dormand_prince.h"

#include <limits>

namespace turgor {
template <int dim>
void TissueState<dim>::archive(Archive &list) {
  list.section("tissue");
  list(time);
  list.fixed(u, v, a, F, P);
  list(viscous, energy);
}

template <int dim>
Integrator<dim>::Integrator(TissueOperator<dim> &op_, const TissueParameters<dim> &parameters_)
    : op(op_), parameters(parameters_), stability(op_) {
  state.u.assign(op.size(), 0.);
  state.v.assign(op.size(), 0.);
  state.a.assign(op.size(), 0.);
  state.F.resize(op.F_bar().size());
  state.P.resize(op.F_bar().size());
}

template <int dim>
void Integrator<dim>::start() {
  if (!op.evaluate(state.time, 0., state.u, state.v)) throw TissueFailed(op.failure(), state.time, 0., 0);
  accept(state.time);
  if (parameters.estimate_every > 0) stability.estimate(state.time, state.u, state.v);
}

template <int dim>
void Integrator<dim>::place(const std::vector<double> &u, const std::vector<double> &v) {
  if (!op.evaluate(state.time, 0., u, v)) throw TissueFailed(op.failure(), state.time, 0., 0);
  state.u = u;
  state.v = v;
  accept(state.time);
  op.law().commit();
  if (parameters.estimate_every > 0) stability.estimate(state.time, state.u, state.v);
  since_estimate = 0;
}

/// As the steps see it, all by the trapezoidal rule: what the viscous stress has done is then heat to the
/// last digit, near the limit of stability too, where rates of the nodes of time are not those between them.
template <int dim>
void Integrator<dim>::add_heat(double time) {
  const LawAnswer<dim> &answer = op.answer();
  if (answer.viscous.empty()) {
    state.heat = std::numeric_limits<double>::signaling_NaN();
    return;
  }
  const double before = state.heating;
  state.heating = 0.;
  double work = 0.;
  for (std::size_t q = 0; q < answer.viscous.size(); ++q) {
    const double weight = op.mesh().gauss_weight[q];
    state.heating += answer.heating.empty() ? 0. : weight * answer.heating[q];
    if (time > state.time)
      work += 0.5 * weight *
              dealii::scalar_product(state.viscous[q] + answer.viscous[q], op.F_bar()[q] - state.F[q]);
  }
  if (time > state.time) state.heat += work + 0.5 * (before + state.heating) * (time - state.time);
}

template <int dim>
void Integrator<dim>::accept(double time, const std::optional<ToolStep> &tools) {
  accelerate();
  const LawAnswer<dim> &answer = op.answer();
  const auto sum = [&](const std::vector<double> &of_point) {
    double result = 0.;
    for (std::size_t q = 0; q < of_point.size(); ++q) result += op.mesh().gauss_weight[q] * of_point[q];
    return result;
  };
  add_heat(time);
  state.spent = sum(answer.spent);
  if (op.tools()) {
    const double force_before = state.tool.force,
                 travel = op.tools()->travel(time) - op.tools()->travel(state.time);
    state.tool = op.tools()->read(time, state.u);
    state.tool_work += tools ? tools->work : 0.5 * (force_before + state.tool.force) * travel;
    if (tools) {
      state.heat += tools->heat;
      state.tool.force = tools->mean.tool;
      state.tool.support = tools->mean.below;
    }
    state.tool.support += op.reaction()[0];
  }
  state.time = time;
  state.F = op.F_bar();
  stability.observe(state.F);
  state.P = answer.P;
  state.viscous = answer.viscous;
  state.energy = answer.energy;
}

template <int dim>
void Integrator<dim>::refresh() {
  if (parameters.estimate_every == 0 || since_estimate < parameters.estimate_every) return;
  stability.estimate(state.time, state.u, state.v);
  since_estimate = 0;
}

template <int dim>
double Integrator<dim>::upcoming(double limit) {
  refresh();
  return state.time + first_try(limit);
}

template <int dim>
void Integrator<dim>::archive(Archive &a) {
  a(state);
  if (op.tools()) a(state.tool, state.tool_work);
  a(state.heating, state.heat, state.spent, state.lent, counters, last_step, since_estimate, stability);
  if (a.loading()) stability.observe(state.F);
}

template <int dim>
std::unique_ptr<Integrator<dim>> make_integrator(TissueOperator<dim> &op,
                                                 const TissueParameters<dim> &parameters) {
  if (parameters.integrator == TimeIntegration::dormand_prince)
    return std::make_unique<DormandPrince<dim>>(op, parameters);
  return std::make_unique<CentralDifferences<dim>>(op, parameters);
}

template struct TissueState<2>;
template struct TissueState<3>;
template class Integrator<2>;
template class Integrator<3>;
template std::unique_ptr<Integrator<2>> make_integrator(TissueOperator<2> &, const TissueParameters<2> &);
template std::unique_ptr<Integrator<3>> make_integrator(TissueOperator<3> &, const TissueParameters<3> &);
}  // namespace turgor
