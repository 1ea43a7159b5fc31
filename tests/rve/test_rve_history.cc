// Yielding and failure in the hydrostatic RVE: closed form, path-dependence, commit and rollback,
// dissipation, tangent, failed cells.
#include "rve/flat_wall_closed_form.h"
#include "rve/hydrostatic_rve.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace turgor;
using turgor::test::matrix;

namespace {
const Tensor2<2> at_rest = Tensor2<2>::Zero();

ParenchymaParameters yielding_cell(const unsigned int nodes = 10) {
  ParenchymaParameters cell;
  cell.nodes_per_side = nodes;
  cell.wall_yield = {15., 0.9};
  return cell;
}

HydrostaticRveSettings plastic() {
  HydrostaticRveSettings s;
  s.walls.plastic = true;
  return s;
}

HydrostaticRveSettings breaking(const double critical, const double leak_time = 0.) {
  HydrostaticRveSettings s = plastic();
  s.walls.critical_stretch = critical;
  s.walls.leak_time = leak_time;
  return s;
}

Tensor2<2> isochoric(const double a) { return matrix(a, 0., 0., 1. / a); }

bool same(const RveState<2> &a, const RveState<2> &b) {
  return a.F == b.F && a.F_dot == b.F_dot && a.unknowns == b.unknowns && a.history == b.history;
}

/// Along the path, committing every answer.
struct Walk {
  const HydrostaticRve &rve;
  std::unique_ptr<Rve<2>::Workspace> workspace;
  RveState<2> state;
  RveAnswer<2> last;

  explicit Walk(const HydrostaticRve &r) : rve(r), workspace(r.make_workspace()), state(r.initial_state()) {}
  const RveAnswer<2> &go(const Tensor2<2> &F, const double dt = 0., const bool tangent = false) {
    last = rve.evaluate(state, F, at_rest, {dt, tangent}, *workspace);
    BOOST_TEST(last.diagnostics.converged, last.diagnostics.message);
    state = last.trial;
    return last;
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(rve_history)

BOOST_AUTO_TEST_CASE(without_it_a_state_has_none) {
  const HydrostaticRve rve(ParenchymaParameters(), {});
  BOOST_TEST(rve.initial_state().history.empty());
  BOOST_TEST(!rve.has_history());
  const HydrostaticRve reversible(yielding_cell(), {});
  BOOST_TEST(reversible.initial_state().history.empty());
}

// Eq. 3.8 while the walls are loaded: the flat-wall closed form with g(lambda) F(lambda), reversible and
// plastic alike, in one step or many. The bound is that of the elastic RVE: walls meet in corners that the
// closed form does not have.
BOOST_AUTO_TEST_CASE(closed_form_with_yielding) {
  const ParenchymaParameters cell = yielding_cell(25);
  const HydrostaticRve reversible(cell, {}), flowing(cell, plastic());
  const FlatWallClosedForm form(cell);
  const auto off = [&](const Tensor2<2> &sigma, const Tensor2<2> &F) {
    const Tensor2<2> d = sigma - form.stress(F);
    return std::abs(d(0, 0) - d(1, 1)) / 2.;
  };
  const auto workspace = reversible.make_workspace();
  Walk steps(flowing);
  // both pairs of walls stay in tension up to here: lambda_0 = 1.03
  for (const double a : {1.005, 1.01, 1.015, 1.02}) {
    const Tensor2<2> F = isochoric(a);
    const double size = std::abs(form.stress(F)(0, 0) - form.stress(F)(1, 1)) / 2.,
                 allowed = std::max(0.01 * size, 0.005 * cell.turgor);
    const RveAnswer<2> one = reversible.evaluate(reversible.initial_state(), F, at_rest, {}, *workspace);
    BOOST_TEST(off(one.sigma, F) < allowed,
               "reversible " << a << ": " << off(one.sigma, F) << " Pa of " << size);
    steps.go(F);
  }
  // sheared at constant height only the leaning walls are loaded, the others keep their length: no unloading
  // anywhere
  Walk shear(flowing), jump(flowing);
  for (const double b : {0.1, 0.2, 0.3}) shear.go(matrix(1., b, 0., 1.));
  jump.go(matrix(1., 0.3, 0., 1.));
  const Tensor2<2> exact = form.stress(matrix(1., 0.3, 0., 1.));
  BOOST_TEST(std::abs(shear.last.sigma(0, 1) - exact(0, 1)) < 0.01 * exact(0, 1));
  BOOST_TEST((shear.last.sigma - jump.last.sigma).norm() < 1e-3 * jump.last.sigma.norm(),
             "steps " << (shear.last.sigma - jump.last.sigma).norm() << " of " << jump.last.sigma.norm());
}

BOOST_AUTO_TEST_CASE(a_stretch_stays) {
  const HydrostaticRve reversible(yielding_cell(), {}), flowing(yielding_cell(), plastic());
  Walk back(reversible), stays(flowing);
  for (const double a : {1.1, 1.2, 1.1, 1.}) {
    back.go(isochoric(a));
    stays.go(isochoric(a));
  }
  BOOST_TEST(back.last.sigma.norm() < 1e-6 * 200e3);
  BOOST_TEST(back.last.condition.permanent == 0.);
  BOOST_TEST(stays.last.sigma.norm() > 0.1 * 200e3, "stress left: " << stays.last.sigma.norm());
  BOOST_TEST(stays.last.condition.permanent > 0.);
  BOOST_TEST(stays.last.condition.flow_dissipated > 0.);
  // The same again stays on the elastic branch: nothing more flows, to round-off
  const double dissipated = stays.last.condition.flow_dissipated;
  for (const double a : {1.05, 1.1, 1.15}) stays.go(isochoric(a));
  BOOST_TEST(std::abs(stays.last.condition.flow_dissipated / dissipated - 1.) < 1e-2);
}

// Same committed state, same bits; a trial that is not committed leaves nothing behind.
BOOST_AUTO_TEST_CASE(evaluate_is_const_in_history) {
  const HydrostaticRve rve(yielding_cell(), breaking(1.25, 1e-4));
  Walk walk(rve);
  walk.go(isochoric(1.1), 1e-6);
  const RveState<2> committed = walk.state;
  const RveAnswer<2> first = rve.evaluate(committed, isochoric(1.15), at_rest, {1e-6, true}, *walk.workspace);
  rve.evaluate(committed, isochoric(1.4), at_rest, {1e-6, false},
               *walk.workspace);  // a rejected one, in which walls break
  const RveAnswer<2> second =
      rve.evaluate(committed, isochoric(1.15), at_rest, {1e-6, true}, *walk.workspace);
  BOOST_TEST(same(walk.state, committed));
  BOOST_TEST(same(first.trial, second.trial));
  BOOST_TEST((first.P.array() == second.P.array()).all());
  BOOST_TEST((first.tangent.array() == second.tangent.array()).all());
  const auto fresh = rve.make_workspace();
  const RveAnswer<2> third = rve.evaluate(committed, isochoric(1.15), at_rest, {1e-6, true}, *fresh);
  BOOST_TEST(same(first.trial, third.trial));
}

// Work done on the RVE = energy stored + energy dissipated. The work is summed by the trapezoidal rule: its
// error falls with the square of the steps.
BOOST_AUTO_TEST_CASE(energy_balance_of_flow) {
  const HydrostaticRve rve(yielding_cell(8), plastic());
  double error[2];
  for (int level = 0; level < 2; ++level) {
    Walk walk(rve);
    const int steps = level == 0 ? 20 : 40;
    double work = 0., dissipated = 0.;
    walk.go(isochoric(1.));
    for (int i = 1; i <= 2 * steps; ++i) {
      const double s = double(i) / steps, b = 0.4 * (s < 1. ? s : 2. - s);
      const Tensor2<2> P = walk.last.P, F = walk.state.F;
      walk.go(matrix(1., b, 0., 1.));
      work += (0.5 * (P + walk.last.P).array() * (walk.state.F - F).array()).sum();
      BOOST_TEST(walk.last.condition.flow_dissipated >= dissipated);
      dissipated = walk.last.condition.flow_dissipated;
    }
    BOOST_TEST(dissipated > 0.05 * 200e3 * 0.4);
    error[level] = std::abs(work - walk.last.energy - dissipated);
    BOOST_TEST(error[level] < 0.02 * dissipated,
               "error " << error[level] << " of " << dissipated << " J/m^3");
  }
  BOOST_TEST(error[1] < 0.4 * error[0], "errors " << error[0] << ", " << error[1]);
}

// dP/dF of the step, loading and unloading: differences of answers from the same committed state.
BOOST_AUTO_TEST_CASE(tangent_on_a_yielding_path) {
  HydrostaticRveSettings settings = plastic();
  settings.equilibrium.tolerance = 1e-12;
  const HydrostaticRve rve(yielding_cell(8), settings);
  Walk walk(rve);
  walk.go(matrix(1., 0.2, 0., 1.));
  for (const double b : {0.25, 0.15}) {
    const Tensor2<2> F = matrix(1.002, b, 0.001, 1.001);
    const auto stress = [&](const Tensor2<2> &G, const bool tangent = false) {
      return rve.evaluate(walk.state, G, at_rest, {0., tangent}, *walk.workspace);
    };
    const Tensor4<2> C = stress(F, true).tangent;
    BOOST_TEST((C - C.transpose()).norm() < 1e-9 * C.norm());  // a potential
    const double h = 1e-5;
    for (int k = 0; k < 4; ++k) {
      Tensor2<2> dF = Tensor2<2>::Zero();
      dF(k / 2, k % 2) = h;
      const Tensor2<2> dP = (stress(F + dF).P - stress(F - dF).P) / (2. * h);
      for (int r = 0; r < 4; ++r)
        BOOST_TEST(std::abs(dP(r / 2, r % 2) - C(r, k)) < 1e-4 * C.cwiseAbs().maxCoeff(),
                   "shear " << b << ", entry " << r << " " << k << ": " << dP(r / 2, r % 2) << " against "
                            << C(r, k));
    }
  }
  // unloading is stiffer than loading
  const RveAnswer<2> up = rve.evaluate(walk.state, matrix(1., 0.21, 0., 1.), at_rest, {}, *walk.workspace),
                     down = rve.evaluate(walk.state, matrix(1., 0.19, 0., 1.), at_rest, {}, *walk.workspace);
  const double middle =
      rve.evaluate(walk.state, matrix(1., 0.2, 0., 1.), at_rest, {}, *walk.workspace).sigma(0, 1);
  BOOST_TEST(middle - down.sigma(0, 1) > 1.5 * (up.sigma(0, 1) - middle));
}

// A bond breaks when its stretch, lambda_0 |F e|, passes lambda_c, and no intact bond stays beyond.
BOOST_AUTO_TEST_CASE(walls_break_beyond_the_critical_stretch) {
  const ParenchymaParameters cell = yielding_cell();
  const double lambda_c = 1.2, lambda_0 = FlatWallClosedForm(cell).lambda_0();
  const HydrostaticRve rve(cell, breaking(lambda_c));
  Walk walk(rve);
  double failed_at = 0.;
  for (double a = 1.; a < 1.4 && failed_at == 0.; a += 0.01) {
    walk.go(isochoric(a));
    if (walk.last.condition.failed > 0.) failed_at = a;
  }
  BOOST_TEST(failed_at > 0.);
  // within a step of the affine stretch; corners make it uneven by less than one more
  BOOST_TEST(std::abs(failed_at - lambda_c / lambda_0) < 0.02,
             "failed at " << failed_at << ", affine " << lambda_c / lambda_0);
  BOOST_TEST(walk.last.condition.failed == 1.);
  BOOST_TEST(walk.last.condition.failure_dissipated > 0.);
  BOOST_TEST(std::abs(walk.last.pressure) < 0.01 * 200e3, "pressure left " << walk.last.pressure);  // at once
  // torn tissue carries far less than the closed form of whole walls
  BOOST_TEST(walk.last.sigma(0, 0) < 0.3 * 200e3, walk.last.sigma(0, 0));
  // failed for good
  walk.go(isochoric(1.));
  BOOST_TEST(walk.last.condition.failed == 1.);
}

// At constant F the pressure of a failed cell falls as exp(-t/tau), whatever the steps.
BOOST_AUTO_TEST_CASE(a_failed_cell_leaks) {
  const double tau = 1e-4;
  const HydrostaticRve rve(yielding_cell(), breaking(1.2, tau));
  Walk few(rve), many(rve);
  const Tensor2<2> F = isochoric(1.25);
  few.go(F, 0.);
  many.go(F, 0.);
  BOOST_TEST(few.last.condition.failed == 1.);
  const double start = few.last.pressure;
  few.go(F, tau);
  for (int i = 0; i < 10; ++i) many.go(F, 0.1 * tau);
  BOOST_TEST(std::abs(few.last.pressure / start - std::exp(-1.)) < 0.02, few.last.pressure / start);
  BOOST_TEST(std::abs(many.last.pressure / start - std::exp(-1.)) < 0.02, many.last.pressure / start);
}

// From whole to drained: work = stored + flow + breaking + what leaks, in every step; in the one in which
// walls break the work is that of the stress with which they came there (RveAnswer::whole).
BOOST_AUTO_TEST_CASE(energy_balance_of_breaking_and_leaking) {
  for (const int steps : {100, 400}) {
    const double tau = 1e-2;
    const HydrostaticRve rve(yielding_cell(8), breaking(1.2, tau));
    Walk walk(rve);
    walk.go(isochoric(1.));
    double most = 0., worst = 0.;
    int broke = 0;
    for (int i = 1; i <= steps; ++i) {
      const RveAnswer<2> before = walk.last;
      const Tensor2<2> F = walk.state.F;
      walk.go(isochoric(1. + 0.3 * i / steps), tau * 3. / steps);
      broke += walk.last.whole.has_value();
      const Tensor2<2> P = walk.last.whole.value_or(walk.last.P);
      const double work = (0.5 * (before.P + P).array() * (walk.state.F - F).array()).sum();
      const double off = work - (walk.last.energy - before.energy) -
                         (walk.last.condition.dissipated() - before.condition.dissipated());
      most += std::abs(work);
      worst += std::abs(off);
      BOOST_TEST(walk.last.whole.has_value() ==
                 (walk.last.condition.failure_dissipated != before.condition.failure_dissipated));
    }
    BOOST_TEST(broke > 0);
    BOOST_TEST(walk.last.condition.failed == 1.);
    BOOST_TEST(walk.last.condition.torn_dissipated > 0.);
    BOOST_TEST_MESSAGE(steps << " steps: work " << most << " J/m^3, torn "
                             << walk.last.condition.torn_dissipated << ", off " << worst);
    BOOST_TEST(worst < (steps == 100 ? 1e-3 : 2e-4) * most, worst << " of " << most);
  }
}

// Pressed together, a drained cell resists by what cannot leave it.
BOOST_AUTO_TEST_CASE(residue_stops_the_collapse) {
  HydrostaticRveSettings settings = breaking(1.2);
  settings.walls.residue = 0.6;
  const HydrostaticRve rve(yielding_cell(), settings);
  Walk walk(rve);
  walk.go(isochoric(1.25));
  BOOST_TEST(walk.last.condition.failed == 1.);
  double last = 0.;
  for (const double J : {0.9, 0.8, 0.7, 0.65, 0.62}) {
    walk.go(matrix(1.25, 0., 0., J / 1.25));
    last = walk.last.pressure;
    BOOST_TEST(last < 0.1 * 200e3, "J = " << J << ": " << last);
  }
  walk.go(matrix(1.25, 0., 0., 0.58 / 1.25));
  BOOST_TEST(walk.last.pressure > 5. * 200e3, walk.last.pressure);
}

// A patch of several cells that tears and is then pressed, sheared and pulled: an answer or a sentence, never
// NaN.
BOOST_AUTO_TEST_CASE(torn_patch_goes_on) {
  HydrostaticRveSettings settings = breaking(1.2, 2e-5);
  settings.columns = settings.rows = 2;
  const HydrostaticRve rve(yielding_cell(8), settings);
  Walk walk(rve);
  int answered = 0, asked = 0;
  for (int i = 1; i <= 60; ++i) {
    const double s = i / 60., a = 1. + 0.5 * std::sin(3. * s), b = 0.4 * s;
    const Tensor2<2> F = matrix(1. / a, b, 0., 0.97 * a);
    const RveAnswer<2> answer = rve.evaluate(walk.state, F, at_rest, {1e-6, false}, *walk.workspace);
    BOOST_TEST(answer.sigma.allFinite());
    BOOST_TEST((answer.diagnostics.converged || !answer.diagnostics.message.empty()));
    ++asked;
    answered += answer.diagnostics.converged;
    if (!answer.diagnostics.dragged)  // which would leave more
      BOOST_TEST(answer.diagnostics.residual <= settings.equilibrium.tolerance);
    if (answer.diagnostics.converged)
      walk.state = answer.trial;
    else
      BOOST_TEST_MESSAGE("step " << i << ": " << answer.diagnostics.message);
    walk.last = answer;
  }
  BOOST_TEST(walk.last.condition.failed > 0.);
  BOOST_TEST(answered == asked, answered << " of " << asked);
}

BOOST_AUTO_TEST_CASE(wrong_input_throws) {
  HydrostaticRveSettings settings = plastic();
  BOOST_CHECK_THROW(HydrostaticRve(ParenchymaParameters(), settings),
                    std::invalid_argument);  // plastic, but nothing yields
  settings = breaking(0.9);
  BOOST_CHECK_THROW(HydrostaticRve(yielding_cell(), settings), std::invalid_argument);
  settings = plastic();
  settings.rule = HydrostaticRule::cauchy_born;
  BOOST_CHECK_THROW(HydrostaticRve(yielding_cell(), settings), std::invalid_argument);
  const HydrostaticRve rve(yielding_cell(), plastic()), plain(ParenchymaParameters(), {});
  const auto workspace = rve.make_workspace();
  RveState<2> foreign = rve.initial_state();
  foreign.history.pop_back();
  BOOST_CHECK_THROW(rve.evaluate(foreign, Tensor2<2>::Identity(), at_rest, {}, *workspace),
                    std::invalid_argument);
  foreign = rve.initial_state();
  foreign.history[5] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(rve.evaluate(foreign, Tensor2<2>::Identity(), at_rest, {}, *workspace),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
