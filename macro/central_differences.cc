#include "macro/central_differences.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr unsigned int most_halvings = 8, steps_before_doubling = 16;
constexpr double parts_of_contact = 32.;  // over the phase of a node that swings on its penalty
}  // namespace

template <int dim>
CentralDifferences<dim>::CentralDifferences(TissueOperator<dim> &op_,
                                            const TissueParameters<dim> &parameters_)
    : Integrator<dim>(op_, parameters_) {}

template <int dim>
double CentralDifferences<dim>::limit_of_stability(double omega, double c) {
  // the root's other form: no cancellation for strong damping
  return 2. / (std::sqrt(c * c + omega * omega) + c);
}

template <int dim>
double CentralDifferences<dim>::stable_step() const {
  const double stable =
      this->parameters.cfl * limit_of_stability(this->stability.frequency(), this->stability.damping());
  return std::ldexp(std::min(stable, this->parameters.tool.longest_step()), -static_cast<int>(halvings));
}

/// Equal steps up to the limit rather than a tiny last one.
template <int dim>
double CentralDifferences<dim>::first_try(double limit) const {
  const double left = limit - this->state.time;
  return left / std::max(1., std::ceil(left / stable_step() * (1. - 1e-12)));
}

template <int dim>
ToolStep CentralDifferences<dim>::move_with_tools(double time, double dt) {
  const TissueOperator<dim> &forces = this->op;
  const double phase = dt * std::sqrt(forces.tools()->frequency2(forces.mass()));
  const int parts = std::max(1, static_cast<int>(std::ceil(parts_of_contact * phase)));
  const double h = dt / parts;
  const auto square = [&] {
    double sum = 0.;
    for (std::size_t i = 0; i < u.size(); ++i) sum += forces.mass()[i] * a_tools[i] * a_tools[i];
    return sum;
  };
  u = this->state.u;
  ToolStep step;
  ToolForces force = forces.acceleration_by_tools(time, u, a_tools);
  double travel = forces.tools()->travel(time);
  const double before = square();
  for (int part = 1; part <= parts; ++part) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      v_half[i] += 0.5 * h * a_tools[i];
      u[i] += h * v_half[i];
    }
    const double now = part == parts ? time + dt : time + part * h, travelled = forces.tools()->travel(now);
    const ToolForces next = forces.acceleration_by_tools(now, u, a_tools);
    for (std::size_t i = 0; i < u.size(); ++i) v_half[i] += 0.5 * h * a_tools[i];
    step.work += 0.5 * (force.tool + next.tool) * (travelled - travel);
    step.mean.tool += 0.5 * (force.tool + next.tool) / parts;
    step.mean.below += 0.5 * (force.below + next.below) / parts;
    force = next;
    travel = travelled;
  }
  lent_by_tools = 0.125 * h * h * (square() - before);
  if (forces.tools()->damped()) {
    for (std::size_t i = 0; i < u.size(); ++i) v_mean[i] = (u[i] - this->state.u[i]) / dt;
    const double speed = (travel - forces.tools()->travel(time)) / dt;
    const ToolStep slowed = forces.slow_at_tools({time + dt, dt, speed}, u, v_mean, v_half);
    step.work += slowed.work;
    step.heat += slowed.heat;
    lent_by_tools += slowed.lent;
    step.mean.tool += slowed.mean.tool;
    step.mean.below += slowed.mean.below;
  }
  return step;
}

template <int dim>
bool CentralDifferences<dim>::attempt(double time, double dt) {
  TissueState<dim> &now = this->state;
  const std::vector<double> &m = this->op.mass();
  const std::size_t n = now.u.size();
  for (std::size_t i = 0; i < n; ++i) {
    v_half[i] = now.v[i] + 0.5 * dt * now.a[i];
    u[i] = now.u[i] + dt * v_half[i];
  }
  std::optional<ToolStep> tools;
  if (this->op.tools()) {
    v_start = v_half;
    tools = move_with_tools(now.time, dt);
  }
  for (std::size_t i = 0; i < n; ++i) v_predicted[i] = v_half[i] + 0.5 * dt * now.a[i];
  if (!this->op.evaluate(time, dt, u, v_predicted)) return false;

  double swing = 0.,
         turned = 0.;  // m (a^2 after - a^2 before); m a . (w - du/dt), before and after the parts
  for (std::size_t i = 0; i < n; ++i) {
    swing -= m[i] * now.a[i] * now.a[i];
    if (tools) {
      const double mean = (u[i] - now.u[i]) / dt;
      turned += m[i] * now.a[i] * (v_start[i] - mean);
      v_start[i] = v_half[i] - mean;
    }
  }
  now.u = u;
  this->accept(time, tools);
  for (std::size_t i = 0; i < n; ++i) {
    swing += m[i] * now.a[i] * now.a[i];
    turned += tools ? m[i] * now.a[i] * v_start[i] : 0.;
    now.v[i] = v_half[i] + 0.5 * dt * now.a[i];
  }
  now.lent += 0.125 * dt * dt * swing;
  if (tools) now.lent += 0.5 * dt * turned + lent_by_tools;
  this->op.law().commit();
  this->last_step = dt;
  return true;
}

template <int dim>
void CentralDifferences<dim>::step(double limit) {
  this->refresh();
  TissueState<dim> &now = this->state;
  const std::size_t n = now.u.size();
  for (auto *vector : {&u, &v_half, &v_predicted, &v_mean}) vector->resize(n);
  while (true) {
    const double dt = first_try(limit), time = dt == limit - now.time ? limit : now.time + dt;
    if (attempt(time, dt)) break;
    ++this->counters.rejected;
    ++this->counters.failures;
    successes = 0;
    if (halvings == most_halvings)  // in all: steps that shrink towards a failure would never reach it
      throw TissueFailed(this->op.failure(), now.time, dt, most_halvings);
    ++halvings;
  }
  ++this->counters.steps;
  ++this->since_estimate;
  if (halvings > 0 && ++successes >= steps_before_doubling) {
    --halvings;
    successes = 0;
  }
}

template <int dim>
void CentralDifferences<dim>::archive(Archive &a) {
  Integrator<dim>::archive(a);
  a(halvings, successes);
}

template class CentralDifferences<2>;
template class CentralDifferences<3>;
}  // namespace turgor
