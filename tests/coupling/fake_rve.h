// An RVE on paper: P = 2 G (F - I) + eta F_dot, energy G |F - I|^2, and a history that counts:
// unknowns[0] of the trial is that of the committed state + 1, unknowns[1] = 10 * that of the
// committed state + F_00. It can be told to fail or throw where F_00 exceeds a bound, and to remember the
// largest F_00 it was committed at as a history, of which its condition tells.
#pragma once

#include "rve/rve.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace turgor::test {
template <int dim>
class FakeRve : public Rve<dim> {
 public:
  double G = 1e6;    // Pa
  double eta = 10.;  // Pa s
  double rho = 1000.;
  double fails_above = std::numeric_limits<double>::infinity();
  double throws_above = std::numeric_limits<double>::infinity();
  double nan_above = std::numeric_limits<double>::infinity();
  double fails_longer_than = std::numeric_limits<double>::infinity();  // s since commit
  double shear_fails_above = std::numeric_limits<double>::infinity();  // |F_10|
  bool remembers = false;
  double told = -1.;  // what it tells of its viscous stress over what it is; negative: nothing
  double step = 0.;   // s, of its iterations
  double drags_above = std::numeric_limits<double>::infinity();  // tells of drag, F_00
  mutable std::atomic<int> calls{0};

  bool has_history() const override { return remembers; }
  bool knows_heating() const override { return told >= 0.; }
  double micro_step() const override { return step; }

  std::unique_ptr<typename Rve<dim>::Workspace> make_workspace() const override {
    return std::make_unique<typename Rve<dim>::Workspace>();
  }

  RveState<dim> initial_state() const override {
    RveState<dim> s;
    s.unknowns = {0., 0.};
    if (remembers) s.history = {1., 0.};
    return s;
  }

  RveAnswer<dim> evaluate(const RveState<dim> &committed, const Tensor2<dim> &F, const Tensor2<dim> &F_dot,
                          const RveRequest &request, typename Rve<dim>::Workspace &) const override {
    ++calls;
    if (!F.allFinite() || F.determinant() <= 0. || F(0, 0) > throws_above)
      throw std::invalid_argument("det F is not positive.");
    RveAnswer<dim> a;
    const Tensor2<dim> E = F - Tensor2<dim>::Identity();
    a.P = 2. * G * E + eta * F_dot;
    a.sigma = a.P * F.transpose() / F.determinant();
    a.viscous = std::max(0., told) * eta * F_dot;
    a.energy = G * E.squaredNorm();
    a.pressure = -a.sigma.trace() / dim;
    if (request.tangent) a.tangent = 2. * G * Tensor4<dim>::Identity();
    if (request.rate_tangent) a.rate_tangent = eta * Tensor4<dim>::Identity();
    a.trial.F = F;
    a.trial.F_dot = F_dot;
    a.trial.unknowns = {committed.unknowns[0] + 1., 10. * committed.unknowns[1] + F(0, 0)};
    if (remembers) {
      a.trial.history = {std::max(committed.history.at(0), F(0, 0)), committed.history.at(1) + 1.};
      a.condition.permanent = a.trial.history[0];
      a.condition.failed = a.trial.history[0] > 2. ? 1. : 0.;
    }
    a.diagnostics.iterations = 3;
    a.diagnostics.dragged = F(0, 0) > drags_above;
    a.diagnostics.residual = a.diagnostics.dragged ? 0.5 : 1e-9;
    a.diagnostics.cpu_seconds = 1e-6 * std::exp(3. * F(0, 0));  // uneven
    if (F(0, 0) > fails_above || request.time_since_commit > fails_longer_than ||
        std::abs(F(1, 0)) > shear_fails_above) {
      a.diagnostics.converged = false;
      a.diagnostics.message = "Newton did not converge.";
    }
    if (F(0, 0) > nan_above) a.P(0, 0) = std::numeric_limits<double>::quiet_NaN();
    return a;
  }

  double density() const override { return rho; }
  double stiffness_bound() const override { return 2. * G; }
  double viscosity_bound() const override { return std::abs(eta); }
  Tensor2<dim> lattice() const override { return 1e-4 * Tensor2<dim>::Identity(); }

  std::vector<std::vector<Vector<dim>>> outlines(const RveState<dim> &state) const override {
    std::vector<Vector<dim>> ring;
    for (int d = 0; d < dim; ++d) ring.push_back(state.F * Vector<dim>::Unit(d) * 1e-4);
    return {ring};
  }
};
}  // namespace turgor::test
