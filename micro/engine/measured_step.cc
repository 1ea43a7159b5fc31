#include "micro/engine/measured_step.h"

#include "micro/laws/counter_random.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace turgor {
namespace {
/// Largest eigenvalue of dt^2 K + 2 dt D in the metric of the masses.
template <int dim>
class StepOperator {
 public:
  StepOperator(ParticleSystem<dim> &system_, const Pace pace_)
      : system(system_),
        pace(pace_),
        x0(system.particles.x),
        v0(system.particles.v),
        kept(system.particles.f),
        n(system.particles.size()) {
    evaluate(f0);
    // A particle's spacing is not known here: a length that no law can overlook and no rounding can blur.
    Vector<dim> low = Vector<dim>::Constant(HUGE_VAL), high = -low;
    for (std::size_t i = 0; i < n; ++i)
      for (int d = 0; d < dim; ++d) {
        low[d] = std::min(low[d], x0[d][i]);
        high[d] = std::max(high[d], x0[d][i]);
      }
    largest_move = 1e-8 * std::pow((high - low).prod() / double(n), 1. / dim);
    if (!(largest_move > 0.)) largest_move = 1e-14;
    basis.resize(std::size_t(dim) * n);
    for (std::size_t k = 0; k < basis.size(); ++k)
      basis[k] = system.particles.inverse_mass[k % n] > 0. ? 2. * random_uniform(20250101, k) - 1. : 0.;
  }

  ~StepOperator() {
    system.particles.x = x0;
    system.particles.v = v0;
    // Whatever a term keeps of its last evaluation (a plate its force, the fluid its densities) is of this
    // state again.
    system.compute_forces();
    system.particles.f = kept;
  }

  double lambda(const double dt) {
    constexpr int most = 40;
    std::vector<double> q = basis, before(q.size(), 0.), w(q.size());
    double beta = std::sqrt(dot(q, q));
    if (!(beta > 0.)) return 0.;
    Eigen::VectorXd diagonal(most), side(most);
    double value = 0.;
    for (int k = 0; k < most; ++k) {
      for (double &a : q) a /= beta;
      multiply(q, dt, w);
      const double alpha = dot(q, w);
      for (std::size_t i = 0; i < w.size(); ++i) w[i] -= alpha * q[i] + (k > 0 ? beta : 0.) * before[i];
      diagonal[k] = alpha;
      beta = std::sqrt(dot(w, w));
      side[k] = beta;
      before.swap(q);
      q.swap(w);
      const bool closed = !(beta > 1e-12 * std::abs(alpha));  // q spans all that K and D make of it
      if ((k >= 7 && k % 4 == 3) || closed) {
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(diagonal.head(k + 1), side.head(k), Eigen::EigenvaluesOnly);
        const double now = solver.eigenvalues()[k];
        if (closed || !std::isfinite(now) || std::abs(now - value) < 5e-3 * std::abs(now)) return now;
        value = now;
      }
    }
    return value;
  }

  unsigned int evaluations = 0;

 private:
  void evaluate(typename Particles<dim>::Components &forces) {
    system.for_groups([&](const std::size_t group) { system.forces_of_group(group, pace); });
    forces = system.particles.f;
    ++evaluations;
  }

  double dot(const std::vector<double> &a, const std::vector<double> &b) const {
    double total = 0.;
    for (std::size_t i = 0; i < a.size(); ++i) total += a[i] * b[i];
    return total;
  }

  /// w = M^-1/2 (dt^2 K + 2 dt D) M^-1/2 q
  void multiply(const std::vector<double> &q, const double dt, std::vector<double> &w) {
    Particles<dim> &p = system.particles;
    double largest = 0.;
    for (std::size_t k = 0; k < q.size(); ++k)
      largest = std::max(largest, std::abs(q[k]) * std::sqrt(p.inverse_mass[k % n]));
    const double e = largest_move / (dt * dt * largest);
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = 0; i < n; ++i) {
        const double u = e * q[d * n + i] * std::sqrt(p.inverse_mass[i]);
        p.x[d][i] = x0[d][i] + dt * dt * u;
        p.v[d][i] = v0[d][i] + 2. * dt * u;
      }
    evaluate(f);
    for (int d = 0; d < dim; ++d)
      for (std::size_t i = 0; i < n; ++i)
        w[d * n + i] = -(f[d][i] - f0[d][i]) / e * std::sqrt(p.inverse_mass[i]);
  }

  ParticleSystem<dim> &system;
  Pace pace;
  const typename Particles<dim>::Components x0, v0, kept;
  typename Particles<dim>::Components f0, f;
  std::size_t n;
  double largest_move = 0.;  ///< m
  std::vector<double> basis;
};
}  // namespace

template <int dim>
double step_eigenvalue(ParticleSystem<dim> &system, const double dt, const Pace pace) {
  return StepOperator<dim>(system, pace).lambda(dt);
}

template <int dim>
MeasuredStep measure_stable_step(ParticleSystem<dim> &system, const double start, const Pace pace) {
  StepOperator<dim> steps(system, pace);
  MeasuredStep found;
  double dt = std::isfinite(start) && start > 0. ? start : 1e-9;
  // lambda grows with dt (all drag) to dt^2 (all stiffness): Newton's method in logarithms, the power from
  // the last two.
  double power = 1.5, last_dt = 0., last_lambda = 0.;
  for (int k = 0; k < 6; ++k) {
    const double lambda = steps.lambda(dt);
    if (!std::isfinite(lambda)) break;  // the caller's own checks say what has happened
    if (!(lambda > 0.)) {
      dt = std::numeric_limits<double>::infinity();
      break;
    }
    if (k > 0 && last_dt != dt)
      power = std::clamp(std::log(lambda / last_lambda) / std::log(dt / last_dt), 1., 2.);
    last_dt = dt;
    last_lambda = lambda;
    const double ratio = 4. / lambda;
    dt *= std::pow(ratio, 1. / power);
    if (std::abs(ratio - 1.) < 0.01) break;
  }
  found.dt = dt;
  found.evaluations = steps.evaluations;
  return found;
}

template double step_eigenvalue<2>(ParticleSystem<2> &, double, Pace);
template double step_eigenvalue<3>(ParticleSystem<3> &, double, Pace);
template MeasuredStep measure_stable_step<2>(ParticleSystem<2> &, double, Pace);
template MeasuredStep measure_stable_step<3>(ParticleSystem<3> &, double, Pace);
}  // namespace turgor
