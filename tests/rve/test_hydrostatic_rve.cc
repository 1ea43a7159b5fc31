// The hydrostatic RVE: closed form, tangent order, objectivity, extremes, bad input.
#include "rve/quadratic_bound.h"
#include "rve/flat_wall_closed_form.h"
#include "rve/hydrostatic_rve.h"
#include "micro/cells/turgid_layout.h"
#include "tests/micro/unlike_cells.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using namespace turgor;
using turgor::test::matrix;

namespace {
RveAnswer<2> answer(const Rve<2> &rve, const Tensor2<2> &F, const Tensor2<2> &F_dot = Tensor2<2>::Zero(),
                    const bool tangent = false) {
  const auto workspace = rve.make_workspace();
  return rve.evaluate(rve.initial_state(), F, F_dot, {0., tangent}, *workspace);
}

Tensor2<2> deviator(const Tensor2<2> &s) { return s - 0.5 * s.trace() * Tensor2<2>::Identity(); }

HydrostaticRveSettings cauchy_born() {
  HydrostaticRveSettings s;
  s.rule = HydrostaticRule::cauchy_born;
  return s;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(hydrostatic_rve)

BOOST_AUTO_TEST_CASE(reference_is_free_of_stress) {
  const HydrostaticRve rve(ParenchymaParameters(), {});
  const RveAnswer<2> at_rest = answer(rve, Tensor2<2>::Identity());
  BOOST_TEST(at_rest.sigma.norm() < 1e-6 * 200e3);
  BOOST_TEST(std::abs(at_rest.energy) < 1e-9 * 200e3);
  BOOST_TEST(at_rest.diagnostics.iterations == 0);
  // by hand: water of 200 kPa (rho_0 (1 + p/K)^(1/7), within 1 % of 1000) and walls 4 * 1 um * 1300 / 100 um
  BOOST_TEST(std::abs(rve.density() - (1000. * std::pow(1. + 200. / 6000., 1. / 7.) + 52.)) < 0.5);
}

// Acceptance: deviatoric stress within max(1 %, 0.5 % of turgor).
BOOST_AUTO_TEST_CASE(closed_form_at_small_and_large_shear) {
  const ParenchymaParameters cell;
  const HydrostaticRve rve(cell, {});
  const FlatWallClosedForm form(cell);
  std::vector<Tensor2<2>> all;
  for (const double a : {0.98, 0.99, 1., 1.01, 1.02}) all.push_back(matrix(a, 0., 0., 1. / a));
  for (const double b : {0.01, 0.05, 0.1, 0.3, 0.6, 1.}) {
    all.push_back(matrix(1., b, 0., 1.));
    all.push_back(matrix(1., 0., b, 1.));
  }
  for (const Tensor2<2> &F : all) {
    const RveAnswer<2> a = answer(rve, F);
    const Tensor2<2> exact = deviator(form.stress(F));
    BOOST_TEST(a.diagnostics.converged);
    const double off = (deviator(a.sigma) - exact).cwiseAbs().maxCoeff();
    BOOST_TEST(off < std::max(0.01 * exact.cwiseAbs().maxCoeff(), 0.005 * cell.turgor),
               "F = " << F << ": off by " << off << " Pa of " << exact.cwiseAbs().maxCoeff());
    BOOST_TEST(std::abs(a.pressure - form.pressure(F)) < 0.02 * cell.turgor);
  }
}

// Without bending the network tends to the closed form as the lamella stiffens: error ~ 1/ratio.
BOOST_AUTO_TEST_CASE(closed_form_is_the_limit_of_stiff_lamella) {
  const Tensor2<2> F = matrix(1.02, 0.05, 0., 1. / 1.02);
  double last = 0.;
  for (const double ratio : {10., 100., 1000.}) {
    ParenchymaParameters cell;
    cell.lamella_ratio = ratio;
    cell.wall_bending = false;
    const FlatWallClosedForm form(cell);
    const RveAnswer<2> a = answer(HydrostaticRve(cell, {}), F);
    BOOST_TEST(a.diagnostics.converged);
    const double off = (deviator(a.sigma) - deviator(form.stress(F))).norm();
    if (last > 0.) BOOST_TEST(std::abs(std::log10(last / off) - 1.) < 0.1);
    last = off;
  }
}

BOOST_AUTO_TEST_CASE(tangent_is_second_order_limit_of_differences) {
  const Tensor2<2> F = matrix(1.01, 0.2, -0.03, 1.), F_dot = matrix(30., 200., -100., 10.);
  for (const bool relaxed : {true, false}) {
    ParenchymaParameters cell;
    cell.nodes_per_side = 8;
    cell.fluid_viscosity = 1.;
    HydrostaticRveSettings settings = relaxed ? HydrostaticRveSettings{} : cauchy_born();
    settings.equilibrium.tolerance = 1e-12;
    const HydrostaticRve rve(cell, settings);
    const Tensor4<2> C = answer(rve, F, F_dot, true).tangent;
    double error[2];
    for (int level = 0; level < 2; ++level) {
      const double h = level == 0 ? 4e-3 : 2e-3;
      error[level] = 0.;
      for (int k = 0; k < 4; ++k) {
        Tensor2<2> dF = Tensor2<2>::Zero();
        dF(k / 2, k % 2) = h;
        const Tensor2<2> dP = (answer(rve, F + dF, F_dot).P - answer(rve, F - dF, F_dot).P) / (2. * h);
        for (int r = 0; r < 4; ++r)
          error[level] = std::max(error[level], std::abs(dP(r / 2, r % 2) - C(r, k)));
      }
    }
    const double order = std::log2(error[0] / error[1]);
    BOOST_TEST(std::abs(order - 2.) < 0.1, "order " << order << ", error " << error[1] << " Pa");
    BOOST_TEST(error[1] < 1e-3 * C.cwiseAbs().maxCoeff());
  }
}

// Cells of their own sizes, strengths and masses: the stress is the slope of the energy, the tangent that of
// the stress; a turned RVE turns its answer.
BOOST_AUTO_TEST_CASE(unlike_cells_answer_as_one_material) {
  HydrostaticRveSettings settings;
  settings.equilibrium.tolerance = 1e-12;
  const CellLayout layout = turgid(test::unlike_cells());
  const HydrostaticRve rve(layout, settings);
  const double volume = layout.lattice.determinant() * layout.parameters.depth;
  BOOST_TEST(rve.density() * volume == layout.total_fluid_mass() + layout.total_wall_mass(),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(answer(rve, Tensor2<2>::Identity()).sigma.trace()) < 1e-6 * 200e3);
  const Tensor2<2> F = matrix(1.005, 0.03, -0.01, 0.998);
  const RveAnswer<2> at = answer(rve, F, Tensor2<2>::Zero(), true);
  BOOST_REQUIRE(at.diagnostics.converged);
  const double h = 2e-4;
  for (int k = 0; k < 4; ++k) {
    Tensor2<2> dF = Tensor2<2>::Zero();
    dF(k / 2, k % 2) = h;
    const RveAnswer<2> plus = answer(rve, F + dF), minus = answer(rve, F - dF);
    BOOST_TEST(std::abs((plus.energy - minus.energy) / (2. * h) - at.P(k / 2, k % 2)) < 1e-4 * at.P.norm());
    for (int r = 0; r < 4; ++r)
      BOOST_TEST(std::abs((plus.P(r / 2, r % 2) - minus.P(r / 2, r % 2)) / (2. * h) - at.tangent(r, k)) <
                 1e-4 * at.tangent.cwiseAbs().maxCoeff());
  }
  const Tensor2<2> Q = matrix(0.8, -0.6, 0.6, 0.8);
  BOOST_TEST((answer(rve, Q * F).sigma - Q * at.sigma * Q.transpose()).norm() < 1e-7 * 200e3);
}

// P is linear in F_dot: differences are exact. A rigid spin costs nothing, and the bound is reached.
BOOST_AUTO_TEST_CASE(rate_tangent_is_the_slope_in_the_rate) {
  ParenchymaParameters cell;
  cell.nodes_per_side = 8;
  cell.fluid_viscosity = 1.7;
  RveRequest request;
  request.rate_tangent = true;
  const Tensor2<2> F = matrix(1.02, 0.2, -0.05, 0.97), F_dot = matrix(300., -1000., 200., -150.);
  for (const bool relaxed : {true, false}) {
    const HydrostaticRve rve(cell, relaxed ? HydrostaticRveSettings{} : cauchy_born());
    const auto workspace = rve.make_workspace();
    const auto rates = [&](const Tensor2<2> &at) {
      return rve.evaluate(rve.initial_state(), at, F_dot, request, *workspace).rate_tangent;
    };
    const Tensor4<2> C = rates(F);
    const double h = 1e6;
    for (int k = 0; k < 4; ++k) {
      Tensor2<2> step = Tensor2<2>::Zero();
      step(k / 2, k % 2) = h;
      const Tensor2<2> slope = (answer(rve, F, F_dot + step).P - answer(rve, F, F_dot - step).P) / (2. * h);
      for (int r = 0; r < 4; ++r) BOOST_TEST(std::abs(slope(r / 2, r % 2) - C(r, k)) < 1e-12 * C.norm());
    }
    const Tensor2<2> spin = matrix(0., -1., 1., 0.) * F;
    BOOST_TEST((C * Eigen::Vector4d(spin(0, 0), spin(0, 1), spin(1, 0), spin(1, 1))).norm() <
               1e-14 * C.norm());
    BOOST_TEST(quadratic_bound<2>(rates(Tensor2<2>::Identity())) == rve.viscosity_bound(),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(answer(rve, F, F_dot).rate_tangent.isZero(0.));
  }
}

// P is the slope of the energy the answer carries.
BOOST_AUTO_TEST_CASE(stress_is_energy_slope) {
  for (const bool relaxed : {true, false}) {
    const HydrostaticRve rve(ParenchymaParameters(), relaxed ? HydrostaticRveSettings{} : cauchy_born());
    const Tensor2<2> F = matrix(1.01, 0.15, 0.02, 0.995), P = answer(rve, F).P;
    const double h = 1e-3;
    for (int k = 0; k < 4; ++k) {
      Tensor2<2> dF = Tensor2<2>::Zero();
      dF(k / 2, k % 2) = h;
      const auto W = [&](const double s) { return answer(rve, F + s * dF).energy; };
      const double slope = (8. * (W(1.) - W(-1.)) - (W(2.) - W(-2.))) / (12. * h);
      BOOST_TEST(std::abs(slope - P(k / 2, k % 2)) < 1e-5 * P.norm());
    }
  }
}

BOOST_AUTO_TEST_CASE(objective) {
  const HydrostaticRve rve(ParenchymaParameters(), {});
  const Tensor2<2> Q = matrix(0.8, -0.6, 0.6, 0.8), F = matrix(1.02, 0.3, 0., 0.99);
  const Tensor2<2> sigma = answer(rve, F).sigma;
  BOOST_TEST((answer(rve, Q * F).sigma - Q * sigma * Q.transpose()).norm() < 1e-6 * sigma.norm());
}

BOOST_AUTO_TEST_CASE(viscous_stress_by_hand) {
  ParenchymaParameters cell;
  cell.fluid_viscosity = 2.;
  const HydrostaticRve rve(cell, {});
  // F = I: L = F_dot; mu (L + L^T + tr L I)
  const RveAnswer<2> a = answer(rve, Tensor2<2>::Identity(), matrix(10., 4., 0., -3.));
  BOOST_TEST((a.sigma - matrix(2. * 27., 8., 8., 2. * 1.)).norm() < 0.3);
}

BOOST_AUTO_TEST_CASE(patch_answers_as_one_cell) {
  ParenchymaParameters cell;
  cell.nodes_per_side = 10;
  HydrostaticRveSettings settings;
  const Tensor2<2> F = matrix(1.01, 0.2, 0., 0.995);
  const Tensor2<2> one = answer(HydrostaticRve(cell, settings), F).sigma;
  settings.columns = 3;
  settings.rows = 2;
  const Tensor2<2> six = answer(HydrostaticRve(cell, settings), F).sigma;
  BOOST_TEST((one - six).norm() < 1e-6 * one.norm());
}

BOOST_AUTO_TEST_CASE(same_bits_whatever_the_workspace_saw) {
  const HydrostaticRve rve(ParenchymaParameters(), {});
  const auto used = rve.make_workspace();
  rve.evaluate(rve.initial_state(), matrix(1.2, 0.5, 0.1, 0.9), Tensor2<2>::Zero(), {0., true}, *used);
  const Tensor2<2> F = matrix(1.01, 0.1, 0., 1.);
  const RveAnswer<2> a = rve.evaluate(rve.initial_state(), F, Tensor2<2>::Zero(), {}, *used),
                     b = answer(rve, F);
  BOOST_TEST((a.trial.unknowns == b.trial.unknowns));
  BOOST_TEST((a.P.array() == b.P.array()).all());
}

BOOST_AUTO_TEST_CASE(extremes_converge_or_say_why) {
  const HydrostaticRve rve(ParenchymaParameters(), {});
  const auto check = [&](const Tensor2<2> &F) {
    const RveAnswer<2> a = answer(rve, F);
    BOOST_TEST(a.sigma.allFinite());
    BOOST_TEST(a.P.allFinite());
    BOOST_TEST((a.diagnostics.converged || !a.diagnostics.message.empty()));
    BOOST_TEST((!a.diagnostics.converged || a.diagnostics.residual <= 1e-9));
    return a.diagnostics.converged;
  };
  for (const double a : {0.5, 0.8, 1.3, 2.}) BOOST_TEST(check(matrix(a, 0., 0., 1. / a)), "isochoric " << a);
  for (const double b : {-1., 1.}) BOOST_TEST(check(matrix(1., b, 0., 1.)));
  for (const double J : {0.98, 1.02})
    BOOST_TEST(check(matrix(std::sqrt(J), 0., 0., std::sqrt(J))), "J " << J);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> stretch(-0.4, 0.4), shear(-1., 1.), volume(0.98, 1.02);
  int reached = 0;
  for (int i = 0; i < 20; ++i) {
    const double a = std::exp(stretch(random));
    reached += check(matrix(1., shear(random), 0., 1.) * matrix(a, 0., 0., volume(random) / a));
  }
  BOOST_TEST(reached >= 18);
}

// Several cells buckle along very soft directions; walking there and jumping there must agree.
BOOST_AUTO_TEST_CASE(buckled_patch_does_not_depend_on_the_way) {
  HydrostaticRveSettings settings;
  settings.columns = settings.rows = 2;
  const HydrostaticRve rve(ParenchymaParameters(), settings);
  const auto workspace = rve.make_workspace();
  RveState<2> state = rve.initial_state();
  for (const double a : {0.99, 0.98, 0.97, 0.96, 0.95}) {
    const RveAnswer<2> step =
        rve.evaluate(state, matrix(a, 0., 0., 1. / a), Tensor2<2>::Zero(), {}, *workspace);
    BOOST_TEST(step.diagnostics.converged, step.diagnostics.message);
    state = step.trial;
    if (a == 0.95) {
      const RveAnswer<2> jump = answer(rve, matrix(a, 0., 0., 1. / a));
      BOOST_TEST(jump.diagnostics.converged, jump.diagnostics.message);
      BOOST_TEST((jump.sigma - step.sigma).norm() < 1e-4 * step.sigma.norm());
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_input_throws) {
  const HydrostaticRve rve(ParenchymaParameters(), {});
  BOOST_CHECK_THROW(answer(rve, matrix(1., 0., 0., -1.)), std::invalid_argument);
  BOOST_CHECK_THROW(answer(rve, matrix(1., 1., 1., 1.)), std::invalid_argument);
  BOOST_CHECK_THROW(answer(rve, matrix(std::numeric_limits<double>::quiet_NaN(), 0., 0., 1.)),
                    std::invalid_argument);
  BOOST_CHECK_THROW(answer(rve, matrix(1., 0., 0., 1.), matrix(HUGE_VAL, 0., 0., 0.)), std::invalid_argument);
  const auto workspace = rve.make_workspace();
  RveState<2> foreign = rve.initial_state();
  foreign.unknowns.resize(10);
  BOOST_CHECK_THROW(rve.evaluate(foreign, Tensor2<2>::Identity(), Tensor2<2>::Zero(), {}, *workspace),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
