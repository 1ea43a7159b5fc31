// Stress given instead of F: against the closed form of flat walls, the elasticity tensor and a Kelvin-Voigt
// body, and what is told where no F carries the stress.
#include "micro/solve/bisection.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/flat_wall_closed_form.h"
#include "rve/make_rve.h"
#include "rve/mixed_control.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>
#include <vector>

using namespace turgor;
using turgor::test::matrix;

namespace {
LoadingEntries loading(const std::string &found, const std::string &stress, const std::string &path,
                       const unsigned int points) {
  LoadingEntries e;
  e.found = found;
  e.stress = stress;
  e.path = path;
  e.points = points;
  return e;
}

const char *const still = "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 1";

struct Walked {
  std::vector<RveAnswer<2>> answers;
  std::string message;
  double time = 0.;
  LoadingPath::Load load;
};

Walked walk(const Rve<2> &rve, const LoadingEntries &entries, const MixedControlSettings &settings = {}) {
  const LoadingPath path(entries);
  MixedControl control(rve, path, settings);
  const auto workspace = rve.make_workspace();
  RveState<2> state = rve.initial_state();
  Walked w;
  w.time = path.times().front();
  for (const double next : path.times()) {
    w.answers.push_back(control.advance(state, w.time, next, w.load, *workspace));
    state = w.answers.back().trial;
    w.message = w.answers.back().diagnostics.message;
    if (!w.answers.back().diagnostics.converged) break;
  }
  return w;
}

RveParameters small(const std::string &structure = "square") {
  RveParameters p;
  p.structure.kind = choice_of<StructureKind>(structure);
  p.cell.nodes_per_side = 8;
  return p;
}

/// F_yy at which P_yy of flat walls is zero.
double free_width(const FlatWallClosedForm &form, const double a) {
  return bisect(
      0.8, 1.2, [&](const double d) { return form.stress(matrix(a, 0., 0., d))(1, 1) < 0.; },
      "the width of flat walls with free sides");
}
}  // namespace

BOOST_AUTO_TEST_SUITE(mixed_control)

// To 3 %, where the walls across are slack. Walls that stay straight differ from the closed form by the
// little the lamella is pressed in the reference: ten times stiffer, ten times less.
BOOST_AUTO_TEST_CASE(uniaxial_stress_is_that_of_flat_walls) {
  RveParameters p = small();
  p.cell.wall_bending = false;
  const FlatWallClosedForm form(p.cell);
  for (const RveRule rule : {RveRule::cauchy_born, RveRule::elastic_equilibrium}) {
    double last = 0.;
    for (const double ratio : {10., 100., 1000.}) {
      p.rule = rule;
      p.cell.lamella_ratio = ratio;
      const Walked w = walk(*make_rve(p), loading("yy", "", "0 : 1, 0; 0, 1 | 1 : 1.03, 0; 0, 1", 4));
      BOOST_REQUIRE_MESSAGE(w.message.empty(), w.message);
      const Tensor2<2> F = w.answers.back().trial.F;
      BOOST_TEST(std::abs(w.answers.back().P(1, 1)) < 1.);
      const double d = free_width(form, 1.03);
      const Tensor2<2> exact = matrix(1.03, 0., 0., d);
      BOOST_REQUIRE(form.applies(exact));
      const double P = form.stress(exact)(0, 0) * d;
      const double off = std::hypot((F(1, 1) - d) / (d - 1.), w.answers.back().P(0, 0) / P - 1.);
      if (last > 0.)
        BOOST_TEST(std::abs(std::log10(last / off) - 1.) < 0.15, ratio << ": " << last << " " << off);
      last = off;
    }
    BOOST_TEST(last < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_compressed_narrows_as_it_is_stretched) {
  RveParameters p = small();
  p.cell.fluid_modulus *= 1e4;
  p.rule = RveRule::cauchy_born;  // relaxed, the lamella gives
  const Walked w = walk(*make_rve(p), loading("yy", "", "0 : 1, 0; 0, 1 | 1 : 1.03, 0; 0, 1", 4));
  BOOST_REQUIRE(w.message.empty());
  const Tensor2<2> F = w.answers.back().trial.F;
  BOOST_TEST(F.determinant() == 1., boost::test_tools::tolerance(1e-6));
  BOOST_TEST(F(1, 1) == 1. / 1.03, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(small_stress_strains_by_the_elasticity_tensor) {
  for (const std::string kind : {"square", "hexagon", "brick", "voronoi"}) {
    RveParameters p = small(kind);
    if (kind == "voronoi") p.columns = p.rows = 2;
    const auto rve = make_rve(p);
    RveRequest request;
    request.tangent = true;
    const auto workspace = rve->make_workspace();
    const Tensor4<2> C =
        rve->evaluate(rve->initial_state(), Tensor2<2>::Identity(), Tensor2<2>::Zero(), request, *workspace)
            .tangent;
    const std::vector<int> kept = {0, 1, 3};
    const Eigen::Matrix3d K = C(kept, kept);
    const Eigen::Vector3d wanted(7., -3., 4.);  // Pa
    const Eigen::Vector3d strain = K.inverse() * wanted;
    const Walked w = walk(*rve, loading("xx, xy, yy", "0 : 0, 0; 0, 0 | 1 : 7, -3; 9, 4", still, 2));
    BOOST_REQUIRE_MESSAGE(w.message.empty(), w.message);
    const Tensor2<2> found = w.answers.back().trial.F - Tensor2<2>::Identity();
    BOOST_TEST(found(1, 0) == 0.);
    const Eigen::Vector3d all(found(0, 0), found(0, 1), found(1, 1));
    BOOST_TEST((all - strain).norm() < 2e-3 * strain.norm(),
               kind << ": " << (all - strain).norm() / strain.norm());
  }
}

// In two directions: eta F_dot + C (F - I) = P from F = I, F - I = (1 - exp(-eta^-1 C t)) C^-1 P; implicit
// Euler comes to it with the first power of the time step.
BOOST_AUTO_TEST_CASE(creep_is_that_of_a_kelvin_voigt_body) {
  RveParameters p = small();
  p.cell.fluid_viscosity = 1.;
  const auto rve = make_rve(p);
  RveRequest request;
  request.tangent = request.rate_tangent = true;
  const auto workspace = rve->make_workspace();
  const RveAnswer<2> at_rest =
      rve->evaluate(rve->initial_state(), Tensor2<2>::Identity(), Tensor2<2>::Zero(), request, *workspace);
  const std::vector<int> kept = {0, 3};
  const Eigen::Matrix2d C = at_rest.tangent(kept, kept), eta = at_rest.rate_tangent(kept, kept);
  const Eigen::EigenSolver<Eigen::Matrix2d> modes(eta.inverse() * C);
  const Eigen::Matrix2d V = modes.eigenvectors().real();
  const Eigen::Vector2d rate = modes.eigenvalues().real();  // 1/s
  const double slow = 1. / rate.minCoeff(), end = 2. * slow;
  const Eigen::Vector2d P(20., -5.), relaxed = C.inverse() * P;
  const auto exact = [&](const double t) -> Eigen::Vector2d {
    const Eigen::Vector2d left = (-rate * t).array().exp();
    return relaxed - V * left.asDiagonal() * V.inverse() * relaxed;
  };
  const std::string t = number_text(end), soon = number_text(1e-9 * end);
  double error[2];
  for (int level = 0; level < 2; ++level) {
    const unsigned int points = level == 0 ? 101 : 201;
    const Walked w = walk(
        *rve, loading("xx, yy", "0 : 0, 0; 0, 0 | " + soon + " : 20, 0; 0, -5 | " + t + " : 20, 0; 0, -5",
                      "0 : 1, 0; 0, 1 | " + t + " : 1, 0; 0, 1", points));
    BOOST_REQUIRE_MESSAGE(w.message.empty(), w.message);
    error[level] = 0.;
    for (std::size_t i = points / 4; i < w.answers.size(); ++i) {
      const Tensor2<2> F = w.answers[i].trial.F - Tensor2<2>::Identity();
      const double time = end * double(i) / (points - 1);
      error[level] =
          std::max(error[level], (Eigen::Vector2d(F(0, 0), F(1, 1)) - exact(time)).norm() / relaxed.norm());
    }
  }
  BOOST_TEST(error[1] < 0.005);
  BOOST_TEST(std::abs(std::log2(error[0] / error[1]) - 1.) < 0.1, error[0] << " " << error[1]);
}

// Loaded in two directions and unloaded, tissue without history comes back.
BOOST_AUTO_TEST_CASE(a_cycle_of_stress_closes) {
  const Walked w = walk(*make_rve(small("brick")),
                        loading("xx, xy, yy", "0 : 0, 0; 0, 0 | 1 : 1e4, 5e3; 0, -1e4 | 2 : 0, 0; 0, 0",
                                "0 : 1, 0; 0, 1 | 2 : 1, 0; 0, 1", 9));
  BOOST_REQUIRE_MESSAGE(w.message.empty(), w.message);
  BOOST_TEST((w.answers[4].trial.F - Tensor2<2>::Identity()).norm() > 0.005);
  BOOST_TEST(w.answers[4].P(0, 1) == 5e3, boost::test_tools::tolerance(1e-6));
  BOOST_TEST((w.answers[8].trial.F - Tensor2<2>::Identity()).norm() < 1e-7);
}

BOOST_AUTO_TEST_CASE(particles_are_loaded_by_stress_too) {
  RveParameters p = small();
  p.fluid = RveFluid::sph;
  p.cell.nodes_per_side = 10;
  p.cell.fluid_viscosity = 1.;
  p.sph.particles_per_side = 9;
  p.sph.anneal_steps = 10000;
  const auto rve = make_rve(p);
  MixedControlSettings settings;
  settings.exact_tangent = false;
  settings.stress_accuracy = 5e-3 * p.cell.turgor;
  LoadingEntries e = loading("yy", "", "0 : 1, 0; 0, 1 | 1 : 1.02, 0; 0, 1", 3);
  const Walked w = walk(*rve, e, settings);
  BOOST_REQUIRE_MESSAGE(w.message.empty(), w.message);
  BOOST_TEST(std::abs(w.answers.back().P(1, 1)) < 5e-3 * p.cell.turgor);
  const double d = free_width(FlatWallClosedForm(p.cell), 1.02);
  BOOST_TEST(w.answers.back().trial.F(1, 1) == d, boost::test_tools::tolerance(5e-3));
}

// Walls that yield without end (B = 1) carry no more than their highest force.
BOOST_AUTO_TEST_CASE(where_no_F_carries_the_stress_it_says_so) {
  RveParameters p = small();
  p.yielding = Yielding::reversible;
  p.yield.drop = 1.;
  const auto rve = make_rve(p);
  const Walked w = walk(*rve, loading("xx, yy", "0 : 0, 0; 0, 0 | 1 : 5e6, 0; 0, 0", still, 101));
  BOOST_REQUIRE(!w.message.empty());
  BOOST_TEST(w.message.find("limit point") != std::string::npos, w.message);
  BOOST_TEST(w.message.find("Give the largest of them as F") != std::string::npos);
  BOOST_TEST(w.time < 1.);
  // The load is that of the last that was found.
  BOOST_TEST(w.load.time == w.time);
  const double reached = w.load.F(0, 0);
  BOOST_TEST(reached > 1.02);
  // The advice: F_xx given goes on, and the stress has its maximum on the way.
  const Walked on = walk(
      *rve,
      loading("yy", "", "0 : 1, 0; 0, 1 | 1 : " + number_text(1. + 1.5 * (reached - 1.)) + ", 0; 0, 1", 41));
  BOOST_REQUIRE_MESSAGE(on.message.empty(), on.message);
  double most = 0.;
  for (const RveAnswer<2> &a : on.answers) most = std::max(most, a.P(0, 0));
  BOOST_TEST(on.answers.back().P(0, 0) < most);
  BOOST_TEST(most == w.load.P(0, 0), boost::test_tools::tolerance(0.01));
}

// Pressed flat with free sides: walls fold, and it is not tension that they do not carry.
BOOST_AUTO_TEST_CASE(tissue_pressed_flat_is_told_apart_from_torn) {
  RveParameters p = small();
  p.cell.nodes_per_side = 25;
  p.max_iterations = 50;
  const Walked w = walk(*make_rve(p), loading("xx", "", "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.01", 8));
  BOOST_TEST_MESSAGE(w.message);
  BOOST_REQUIRE(!w.message.empty());
  BOOST_TEST(w.load.F(1, 1) < 0.5);
  BOOST_TEST(w.message.find("There the tissue is pressed to ") != std::string::npos);
  BOOST_TEST(w.message.find("Take more Path/Points") == std::string::npos);
  BOOST_TEST(w.message.find(".)") == std::string::npos);
  // The advice: at less of it the path is walked to its end.
  const Walked less =
      walk(*make_rve(p),
           loading("xx", "", "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, " + number_text(1.05 * w.load.F(1, 1)), 8));
  BOOST_TEST(less.message == "");
}

// Bricks pressed with free sides until a wall breaks: its cell drains, the stress jumps, and the path goes on
// with what is left, in balance at every point.
BOOST_AUTO_TEST_CASE(what_is_left_of_broken_walls_carries_on) {
  RveParameters p = small("brick");
  p.columns = 2;
  p.rows = 2;
  p.structure.jitter = 0.06;
  p.walls.critical_stretch = 1.1;
  MixedControlSettings settings;
  settings.torn_accuracy = 1e-3 * p.cell.turgor;
  const Walked w = walk(*make_rve(p), loading("xx", "", "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.84", 17), settings);
  BOOST_REQUIRE_MESSAGE(w.answers.size() == 17u && w.answers.back().diagnostics.converged, w.message);
  double before = 0.;
  for (const RveAnswer<2> &answer : w.answers) {
    BOOST_TEST(std::abs(answer.P(0, 0)) <
               (answer.condition.failure_dissipated > 0. ? settings.torn_accuracy : 1e-6 * p.cell.turgor));
    BOOST_TEST(answer.condition.failed >= before);
    if (before == 0. && answer.condition.failed == 0.) BOOST_TEST(answer.P(1, 1) <= 1.);
    before = answer.condition.failed;
  }
  BOOST_TEST(before > 0.);
  BOOST_TEST(before < 1.);
}

BOOST_AUTO_TEST_CASE(wrong_components_are_named) {
  const auto refused = [](const LoadingEntries &e, const std::string &words) {
    BOOST_CHECK_EXCEPTION(LoadingPath{e}, InputError, [&](const InputError &error) {
      return std::string(error.what()).find(words) != std::string::npos;
    });
  };
  refused(loading("xy, yx", "", still, 2), "it fixes the rotation");
  refused(loading("xx, zz", "", still, 2), "allowed are none or a list");
  refused(loading("xx, xx", "", still, 2), "xx is named twice");
  refused(loading("none", "0 : 0, 0; 0, 0", still, 2), "finds no F for it");
  refused(loading("xx", "0 : nan, 0; 0, 0", still, 2), "finite number");
  refused(loading("xx", "0 : 1e12, 0; 0, 0", still, 2), "allowed are 1e+09");
  refused(loading("xx", "1 : 0, 0; 0, 0 | 0 : 1, 0; 0, 0", still, 2), "times have to rise");
}

BOOST_AUTO_TEST_SUITE_END()
