// An elastic RVE on paper that is cheap, objective, of square symmetry and not linear, with a flow of
// viscosity mu beside it:
//
//   W(E) = p0 tr E + k (E_xx^2 + E_yy^2)/2 + l E_xx E_yy + m E_xy^2 + c (E_xx^3 + E_yy^3)/6 + d (E_xx + E_yy)
//     E_xy^2,   P = F dW/dE
//
// It can keep a history: the largest E_xx beyond `limit`, from where it answers with half the stress.
#pragma once

#include "coupling/answer_record.h"
#include "rve/affine_flow.h"
#include "rve/rve.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>

namespace turgor::test {
class SmoothRve : public Rve<2> {
 public:
  double p0 = 1e4, k = 2e6, l = 8e5, m = 6e5, c = 4e7, d = 2e7;  // Pa
  double mu = 1.;                                                // Pa s
  double limit = std::numeric_limits<double>::infinity();
  std::size_t size = 200;  // unknowns
  mutable std::atomic<int> calls{0};

  bool has_history() const override { return limit < 1e300; }
  bool knows_heating() const override { return true; }
  double flow_viscosity() const override { return mu; }
  std::vector<Tensor2<2>> symmetries() const override {
    Tensor2<2> mirror, swap;
    mirror << 1., 0., 0., -1.;
    swap << 0., 1., 1., 0.;
    return {mirror, swap, swap * mirror};
  }

  std::unique_ptr<Workspace> make_workspace() const override { return std::make_unique<Workspace>(); }

  RveState<2> initial_state() const override {
    RveState<2> s;
    s.unknowns.assign(size, 0.);
    if (has_history()) s.history = {0.};
    return s;
  }

  double energy(const Tensor2<2> &F) const {
    const Tensor2<2> E = 0.5 * (F.transpose() * F - Tensor2<2>::Identity());
    const double x = E(0, 0), y = E(1, 1), s = E(0, 1);
    return p0 * (x + y) + 0.5 * k * (x * x + y * y) + l * x * y + m * s * s +
           c * (x * x * x + y * y * y) / 6. + d * (x + y) * s * s;
  }

  Tensor2<2> elastic_P(const Tensor2<2> &F) const {
    const Tensor2<2> E = 0.5 * (F.transpose() * F - Tensor2<2>::Identity());
    const double x = E(0, 0), y = E(1, 1), s = E(0, 1);
    Tensor2<2> S;
    S(0, 0) = p0 + k * x + l * y + 0.5 * c * x * x + d * s * s;
    S(1, 1) = p0 + k * y + l * x + 0.5 * c * y * y + d * s * s;
    S(0, 1) = S(1, 0) = m * s + d * (x + y) * s;
    return F * S;
  }

  RveAnswer<2> evaluate(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                        const RveRequest &request, Workspace &) const override {
    ++calls;
    if (!(F.determinant() > 0.)) throw std::invalid_argument("det F is not positive.");
    const StrainVector<2> E = green_strain<2>(F);
    const AffineFlow<2> flow(mu, F, F_dot);
    RveAnswer<2> a;
    a.trial = committed;
    a.trial.F = F;
    a.trial.F_dot = F_dot;
    double share = 1.;
    if (has_history()) {
      a.trial.history = {std::max(committed.history.at(0), E[0] > limit ? E[0] : 0.)};
      share = a.trial.history[0] > 0. ? 0.5 : 1.;
      a.safe_strain = share < 1. ? -1. : limit - E[0];
    }
    a.viscous = flow.P();
    a.P = share * elastic_P(F) + a.viscous;
    a.sigma = a.P * F.transpose() / F.determinant();
    a.energy = share * energy(F);
    a.pressure = -a.sigma.trace() / 2.;
    if (request.tangent) {
      const double x = E[0], y = E[1], s = E[2] / std::sqrt(2.), r = std::sqrt(2.) * d * s;
      StrainMatrix<2> C;
      C << k + c * x, l, r, l, k + c * y, r, r, r, m + d * (x + y);
      a.tangent = share * elastic_tangent<2>(F, to_vector<2>(F.inverse() * elastic_P(F)), C) + flow.tangent();
    }
    a.diagnostics.iterations = 2;
    a.diagnostics.cpu_seconds = 1e-5;
    return a;
  }

  double density() const override { return 1000.; }
  double stiffness_bound() const override { return 2. * (k + l); }
  double viscosity_bound() const override { return AffineFlow<2>::largest_viscosity(mu); }
  Tensor2<2> lattice() const override { return 1e-4 * Tensor2<2>::Identity(); }
  std::vector<std::vector<Vector<2>>> outlines(const RveState<2> &) const override { return {}; }
};
}  // namespace turgor::test
