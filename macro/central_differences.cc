#include "macro/central_differences.h"

#include "macro/binary.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
namespace
{
constexpr unsigned int most_halvings = 8, steps_before_doubling = 16;
}

template <int dim>
CentralDifferences<dim>::CentralDifferences(TissueOperator<dim> &op_, const TissueParameters<dim> &parameters_)
  : Integrator<dim>(op_, parameters_)
{}

template <int dim>
double CentralDifferences<dim>::limit_of_stability(double omega, double c)
{
  // the root's other form: no cancellation for strong damping
  return 2. / (std::sqrt(c * c + omega * omega) + c);
}

template <int dim>
double CentralDifferences<dim>::stable_step() const
{
  const double stable = this->parameters.cfl * limit_of_stability(this->stability.frequency(), this->stability.damping());
  return std::ldexp(std::min(stable, this->parameters.tool.longest_step()), -static_cast<int>(halvings));
}

template <int dim>
void CentralDifferences<dim>::step(double limit)
{
  this->refresh();
  TissueState<dim> &now = this->state;
  const std::size_t n = now.u.size();
  u.resize(n);
  v_half.resize(n);
  v_predicted.resize(n);
  while (true)
    {
      // equal steps up to the limit rather than a tiny last one
      const double left = limit - now.time;
      const double pieces = std::max(1., std::ceil(left / stable_step() * (1. - 1e-12)));
      const double dt = left / pieces, time = pieces == 1. ? limit : now.time + dt;
      for (std::size_t i = 0; i < n; ++i)
        {
          v_half[i] = now.v[i] + 0.5 * dt * now.a[i];
          u[i] = now.u[i] + dt * v_half[i];
          v_predicted[i] = v_half[i] + 0.5 * dt * now.a[i];
        }
      if (this->op.evaluate(time, dt, u, v_predicted))
        {
          now.u = u;
          double swing = 0.; // m (a^2 after - a^2 before)
          for (std::size_t i = 0; i < n; ++i)
            swing -= this->op.mass()[i] * now.a[i] * now.a[i];
          this->accept(time);
          for (std::size_t i = 0; i < n; ++i)
            swing += this->op.mass()[i] * now.a[i] * now.a[i];
          now.lent += 0.125 * dt * dt * swing;
          for (std::size_t i = 0; i < n; ++i)
            now.v[i] = v_half[i] + 0.5 * dt * now.a[i];
          this->op.law().commit();
          this->last_step = dt;
          break;
        }
      ++this->counters.rejected;
      ++this->counters.failures;
      successes = 0;
      if (halvings == most_halvings) // in all: steps that shrink towards a failure would never reach it
        throw TissueFailed(this->op.failure(), now.time, dt, most_halvings);
      ++halvings;
    }
  ++this->counters.steps;
  ++this->since_estimate;
  if (halvings > 0 && ++successes >= steps_before_doubling)
    {
      --halvings;
      successes = 0;
    }
}

template <int dim>
void CentralDifferences<dim>::save(std::ostream &out) const
{
  Integrator<dim>::save(out);
  write_binary(out, halvings);
  write_binary(out, successes);
}

template <int dim>
void CentralDifferences<dim>::load(std::istream &in)
{
  Integrator<dim>::load(in);
  read_binary(in, halvings);
  read_binary(in, successes);
}

template class CentralDifferences<2>;
template class CentralDifferences<3>;
} // namespace turgor
