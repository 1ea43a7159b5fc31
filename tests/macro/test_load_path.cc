// A tissue followed along its loading: tangents, the quadratic tail, closed forms, energy, steps that fail.
#include "tests/macro/tissue_fixture.h"

#include "macro/load_path.h"
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(load_path)

namespace {
constexpr double soft_lambda = 10. * mu;

TissueParameters<2> pressed(const ToolShape shape, const unsigned int elements = 4) {
  TissueParameters<2> p;
  p.size = {width, width};
  p.elements = {elements, elements};
  p.left = LeftSide::plate;
  p.tool.shape = shape;
  p.tool.motion = ToolMotion::steady;
  p.tool.radius = width;
  p.tool.speed = 1e-3;
  p.tool.depth = 0.3 * width;
  return p;
}

LoadPathSettings slowly(const TissueParameters<2> &p, const double largest = 0.1) {
  LoadPathSettings s;
  s.end = p.tool.depth / p.tool.speed;
  s.first_step = s.largest_step = largest;
  return s;
}

/// P_xx of an even block stretched to F_xx by plates with free sides, and its F_yy: P_yy = 0 by bisection.
std::array<double, 2> uniaxial(const double stretch) {
  const auto P = [&](const double along, const double across) {
    return mu * (along - 1. / along) + soft_lambda * std::log(along * across) / along;
  };
  double low = 0.5, high = 2.;
  for (int k = 0; k < 100; ++k) (P(0.5 * (low + high), stretch) > 0. ? high : low) = 0.5 * (low + high);
  return {P(stretch, low), low};
}
}  // namespace

BOOST_AUTO_TEST_CASE(the_tangent_is_the_derivative_of_the_balance) {
  for (const ToolShape shape : {ToolShape::plate, ToolShape::cylinder}) {
    TissueParameters<2> p = pressed(shape);
    p.body_force[1] = -50.;
    NeoHookeanLaw<2> law(mu, soft_lambda, 0., rho);
    TissueMesh<2> mesh(p);
    TissueOperator<2> op(mesh, p, law);
    StaticBalance<2> balance(op, {});
    std::vector<double> u = wavy(mesh, 0.02 * width, 0.4), along = wavy(mesh, 1., 1.3);
    for (std::size_t i = 0; i < u.size(); i += 2) u[i] -= 0.05 * width;  // well into the plate below
    const LoadPlace place{0.2 * width / p.tool.speed, 0., 0.7};
    BOOST_REQUIRE(balance.evaluate(u, place));
    BOOST_REQUIRE(op.tools()->tangent(place.time, u).blocks.size() >= 6u);
    balance.linearise();
    // K^-1 of the derivative along a direction is that direction
    const double h = 1e-7 * width;
    std::vector<double> sides[2];
    for (int k = 0; k < 2; ++k) {
      std::vector<double> there = u;
      for (std::size_t i = 0; i < u.size(); ++i) there[i] += (k == 0 ? -h : h) * along[i];
      BOOST_REQUIRE(balance.evaluate(there, place));
      sides[k] = balance.residual();
    }
    for (std::size_t i = 0; i < u.size(); ++i) sides[0][i] = (sides[0][i] - sides[1][i]) / (2. * h);
    const std::vector<double> back = balance.solve(sides[0]);
    double worst = 0.;
    for (std::size_t i = 0; i < u.size(); ++i) worst = std::max(worst, std::abs(back[i] - along[i]));
    BOOST_TEST_MESSAGE((shape == ToolShape::plate ? "plate" : "cylinder")
                       << ": tangent against differences: " << worst);
    BOOST_TEST(worst < 1e-5);

    // by travel
    BOOST_REQUIRE(balance.evaluate(u, place));
    const std::vector<double> told = balance.by_travel();
    for (int k = 0; k < 2; ++k) {
      LoadPlace other = place;
      other.time += (k == 0 ? -h : h) / p.tool.speed;
      BOOST_REQUIRE(balance.evaluate(u, other));
      sides[k] = balance.residual();
    }
    for (std::size_t i = 0; i < u.size(); ++i)
      BOOST_TEST(std::abs((sides[1][i] - sides[0][i]) / (2. * h) - told[i]) < 1e-5 * mu);
  }
}

BOOST_AUTO_TEST_CASE(an_even_block_between_plates_follows_the_closed_form) {
  const TissueParameters<2> p = pressed(ToolShape::plate);
  NeoHookeanLaw<2> law(mu, soft_lambda, 0., rho);
  Tissue<2> tissue(p, law);
  const LoadPathSettings s = slowly(p);
  LoadPath<2> path(tissue, s);
  path.start();
  while (path.time() < s.end) {
    path.step(s.end);
    const TissueState<2> &state = tissue.state();
    const auto [P, across] = uniaxial(state.F[0][0][0]);
    for (std::size_t q = 0; q < state.F.size(); ++q) {
      BOOST_TEST(std::abs(state.F[q][0][0] - state.F[0][0][0]) < 1e-8);
      BOOST_TEST(std::abs(state.F[q][1][1] - across) < 1e-8);
    }
    BOOST_TEST(std::abs(state.tool.force + P * width) < 1e-7 * std::abs(P) * width);
    BOOST_TEST(std::abs(state.tool.support - state.tool.force) < 1e-7 * std::abs(P) * width);
  }
  BOOST_TEST(tissue.state().F[0][0][0] < 0.75);
  BOOST_TEST(path.counters().halved == 0u);
}

BOOST_AUTO_TEST_CASE(newton_is_quadratic_under_a_cylinder) {
  TissueParameters<2> p = pressed(ToolShape::cylinder, 8);
  p.left = LeftSide::clamped;
  NeoHookeanLaw<2> law(mu, soft_lambda, 0., rho);
  Tissue<2> tissue(p, law);
  LoadPathSettings s = slowly(p);
  s.newton.tolerance = 1e-11;
  LoadPath<2> path(tissue, s);
  path.start();
  unsigned int seen = 0;
  while (path.time() < s.end) {
    path.step(s.end);
    const std::vector<double> &r = path.residuals();
    const std::size_t n = r.size();
    // the last three: the nodes in contact are the same ones by then
    if (n < 4 || !(r[n - 2] < 1e-3)) continue;
    ++seen;
    BOOST_TEST(r[n - 1] < 1e3 * r[n - 2] * r[n - 2] + 1e-11, r[n - 3] << " " << r[n - 2] << " " << r[n - 1]);
  }
  BOOST_TEST(seen >= 5u);
  BOOST_TEST_MESSAGE("last search: " << path.residuals()[0] << " ... " << path.residuals().back() << " in "
                                     << path.residuals().size() - 1);
}

BOOST_AUTO_TEST_CASE(the_gap_of_energy_falls_with_the_square_of_the_step) {
  double gap[2];
  for (int k = 0; k < 2; ++k) {
    TissueParameters<2> p = pressed(ToolShape::plate);
    p.traction[1] = 0.02 * mu;
    p.left = LeftSide::clamped;
    NeoHookeanLaw<2> law(mu, soft_lambda, 0., rho);
    Tissue<2> tissue(p, law);
    const LoadPathSettings s = slowly(p, k == 0 ? 0.1 : 0.05);
    LoadPath<2> path(tissue, s);
    path.start();
    while (path.time() < s.end) path.step(s.end);
    const PathEnergies &e = path.energies();
    gap[k] = e.gap() / e.work;
    BOOST_TEST(e.released == 0.);
    BOOST_TEST_MESSAGE(path.counters().steps << " steps: gap over work " << gap[k]);
    BOOST_TEST(std::abs(gap[k]) < 0.01);
  }
  BOOST_TEST(gap[0] / gap[1] > 3.);
  BOOST_TEST(gap[0] / gap[1] < 5.);
}

BOOST_AUTO_TEST_CASE(what_fails_or_is_refused_is_tried_in_smaller_steps) {
  const TissueParameters<2> p = pressed(ToolShape::plate);
  FailingLaw law(mu, soft_lambda, 0., rho);
  Tissue<2> tissue(p, law);
  LoadPathSettings s = slowly(p);
  LoadPath<2> path(tissue, s);
  path.start();
  law.fail_from = law.calls;
  law.fail_to = law.calls + 2;
  path.step(s.end);
  BOOST_TEST(path.counters().halved >= 1u);
  BOOST_TEST(path.last_step() < 0.051 * s.end);
  unsigned int asked = 0;
  path.too_much = [&] { return ++asked <= 2; };
  const double before = path.time();
  path.step(s.end);
  BOOST_TEST(path.counters().refused == 2u);
  BOOST_TEST(path.time() - before < 0.026 * s.end);

  // for good: a sentence, and the state before
  path.too_much = nullptr;
  const std::vector<double> u = tissue.state().u;
  const double time = path.time();
  law.fail_from = law.calls;
  law.fail_to = law.calls + 1000000;
  BOOST_CHECK_EXCEPTION(path.step(s.end), PathEnds, [&](const PathEnds &e) {
    BOOST_TEST_MESSAGE(e.what());
    return e.time == time &&
           std::string(e.what()).find("the cell wall cannot be balanced") != std::string::npos;
  });
  BOOST_TEST((tissue.state().u == u));
  BOOST_TEST(path.time() == time);
}

BOOST_AUTO_TEST_CASE(a_path_goes_on_from_its_archive_with_the_same_bits) {
  const TissueParameters<2> p = pressed(ToolShape::cylinder);
  const LoadPathSettings s = slowly(p);
  NeoHookeanLaw<2> law(mu, soft_lambda, 0., rho), other(mu, soft_lambda, 0., rho);
  Tissue<2> tissue(p, law), again(p, other);
  LoadPath<2> path(tissue, s), resumed(again, s);
  path.start();
  for (int k = 0; k < 4; ++k) path.step(s.end);
  restore(archived(path), resumed);
  while (path.time() < s.end) path.step(s.end);
  while (resumed.time() < s.end) resumed.step(s.end);
  BOOST_TEST((tissue.state().u == again.state().u));
  BOOST_TEST(path.energies().work == resumed.energies().work);
  BOOST_TEST(path.counters().iterations == resumed.counters().iterations);
}

BOOST_AUTO_TEST_CASE(steps_that_cannot_be_are_refused) {
  LoadPathSettings s;
  s.first_step = 0.5;
  BOOST_CHECK_EXCEPTION(s.check(), std::invalid_argument, [](const std::invalid_argument &e) {
    return std::string(e.what()) ==
           "Load steps must have 0 < Smallest <= First <= Largest <= 1; they are 1e-05, 0.5 and 0.02.";
  });
}

BOOST_AUTO_TEST_SUITE_END()
