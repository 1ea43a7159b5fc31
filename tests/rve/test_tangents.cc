// What tangents tell: tensors against differences with their order, symmetry, rotation, viscosity against the
// flow's own, and the acoustic tensor's smallest eigenvalue.
#include "rve/elastic_tangent.h"
#include "rve/ellipticity.h"
#include "rve/make_rve.h"
#include "rve/mixed_control.h"
#include "rve/plane_moduli.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace turgor;
using turgor::test::matrix;

namespace {
RveParameters tissue(const std::string &kind, const double degrees = 0.) {
  RveParameters p;
  p.structure.kind = choice_of<StructureKind>(kind);
  p.structure.rotation = degrees;
  p.cell.period = 100e-6;
  p.cell.nodes_per_side = 12;
  p.cell.lamella_ratio = 1.;
  if (kind == "voronoi") p.columns = p.rows = 3;
  return p;
}

RveAnswer<2> answer_at(const Rve<2> &rve, const Tensor2<2> &F, const Tensor2<2> &F_dot = Tensor2<2>::Zero()) {
  const auto workspace = rve.make_workspace();
  RveRequest request;
  request.tangent = request.rate_tangent = true;
  RveAnswer<2> a = rve.evaluate(rve.initial_state(), F, F_dot, request, *workspace);
  BOOST_REQUIRE_MESSAGE(a.diagnostics.converged, a.diagnostics.message);
  return a;
}

Tensor2<2> unit(const int k) {
  Tensor2<2> dF = Tensor2<2>::Zero();
  dF(k / 2, k % 2) = 1.;
  return dF;
}

/// A material as stiff as a fluid against sliding and as K against changes of volume, with mu against shear.
Tensor4<2> isotropic(const double K, const double mu) {
  Tensor4<2> C = Tensor4<2>::Zero();
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d)
          C(2 * a + b, 2 * c + d) =
              (K - mu) * (a == b) * (c == d) + mu * ((a == c) * (b == d) + (a == d) * (b == c));
  return C;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(tangents)

BOOST_AUTO_TEST_CASE(elasticity_is_the_limit_of_differences_of_second_order) {
  for (const std::string kind : {"square", "hexagon", "brick", "voronoi"}) {
    RveParameters p = tissue(kind);
    p.cell.fluid_viscosity = 0.;
    p.tolerance = 1e-12;
    const auto rve = make_rve(p);
    const Tensor4<2> C = answer_at(*rve, Tensor2<2>::Identity()).tangent;
    double error[2];
    for (int level = 0; level < 2; ++level) {
      const double h = level == 0 ? 2e-3 : 1e-3;
      error[level] = 0.;
      for (int k = 0; k < 4; ++k) {
        const Tensor2<2> I = Tensor2<2>::Identity();
        const Tensor2<2> dP =
            (answer_at(*rve, I + h * unit(k)).P - answer_at(*rve, I - h * unit(k)).P) / (2. * h);
        for (int r = 0; r < 4; ++r)
          error[level] = std::max(error[level], std::abs(dP(r / 2, r % 2) - C(r, k)));
      }
    }
    const double order = std::log2(error[0] / error[1]);
    BOOST_TEST(std::abs(order - 2.) < 0.1, kind << ": order " << order << ", error " << error[1] << " Pa");
    BOOST_TEST((C - C.transpose()).cwiseAbs().maxCoeff() < 1e-12 * C.cwiseAbs().maxCoeff());
    BOOST_TEST(PlaneModuli(C).smallest() > 1e4, kind);  // positive definite: stable at rest
    // Turned without being strained, tissue without stress answers with none.
    BOOST_TEST((C * Eigen::Vector4d(0., -1., 1., 0.)).cwiseAbs().maxCoeff() < 1e-6 * p.cell.turgor, kind);
  }
}

// C_abcd of a layout turned by Q is Q_ai Q_bj Q_ck Q_dl C_ijkl.
BOOST_AUTO_TEST_CASE(a_turned_tissue_turns_its_tensors) {
  constexpr double degrees = 35., angle = degrees * std::numbers::pi / 180.;
  const Tensor2<2> Q = matrix(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
  Tensor4<2> turn;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) turn(r, c) = Q(r / 2, c / 2) * Q(r % 2, c % 2);
  for (const std::string kind : {"square", "hexagon", "brick", "voronoi"}) {
    const RveAnswer<2> as_is = answer_at(*make_rve(tissue(kind)), Tensor2<2>::Identity()),
                       turned = answer_at(*make_rve(tissue(kind, degrees)), Tensor2<2>::Identity());
    const Tensor4<2> expected = turn * as_is.tangent * turn.transpose(),
                     flow = turn * as_is.rate_tangent * turn.transpose();
    BOOST_TEST((turned.tangent - expected).cwiseAbs().maxCoeff() < 1e-8 * expected.cwiseAbs().maxCoeff(),
               kind);
    BOOST_TEST((turned.rate_tangent - flow).cwiseAbs().maxCoeff() < 1e-12 * flow.cwiseAbs().maxCoeff(), kind);
    const PlaneModuli before(as_is.tangent), after(turned.tangent);
    for (const double at : {0., 0.4, 1.1})
      for (const auto &[found, wanted] : {std::pair(after.free(at + angle), before.free(at)),
                                          std::pair(after.shear(at + angle), before.shear(at))})
        BOOST_TEST(found == wanted, boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(hexagons_have_one_shear_modulus_to_a_hundredth) {
  const PlaneModuli found(answer_at(*make_rve(tissue("hexagon")), Tensor2<2>::Identity()).tangent);
  for (const double angle : {0.2, 0.5, 0.9, 1.3}) {
    BOOST_TEST(found.shear(angle) == found.shear(0.), boost::test_tools::tolerance(0.01));
    BOOST_TEST(found.free(angle) == found.free(0.), boost::test_tools::tolerance(0.01));
  }
  // an isotropic plane: E = 4 K mu/(K + mu) by its held modulus K + mu
  const double mu = found.shear(0.), K = found.held_x - mu;
  BOOST_TEST(found.free(0.) == 4. * K * mu / (K + mu), boost::test_tools::tolerance(0.01));
}

// Where there are no gaps the fluid flows with F: mu (L + L^T + tr(L) I) for every structure, so that P is
// linear in F_dot and a spin costs nothing.
BOOST_AUTO_TEST_CASE(viscosity_of_square_honeycomb_and_brick_is_that_of_the_flow) {
  constexpr double mu = 1.7;
  for (const std::string kind : {"square", "hexagon", "brick"}) {
    RveParameters p = tissue(kind);
    p.cell.fluid_viscosity = mu;
    const auto rve = make_rve(p);
    const Tensor4<2> eta = answer_at(*rve, Tensor2<2>::Identity()).rate_tangent;
    // K - mu = mu against volume beside 2 mu against strain: isotropic(2 mu, mu)
    BOOST_TEST((eta - isotropic(2. * mu, mu)).cwiseAbs().maxCoeff() < 1e-12 * mu, kind);
    const PlaneModuli flow(eta);
    for (const double angle : {0., 0.3, 0.8, 1.2}) {
      BOOST_TEST(flow.shear(angle) == mu, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(flow.free(angle) == 8. / 3. * mu, boost::test_tools::tolerance(1e-12));
    }
    const Tensor2<2> F = matrix(1.02, 0.1, -0.05, 0.99);
    const RveAnswer<2> at = answer_at(*rve, F);
    BOOST_TEST((at.rate_tangent - at.rate_tangent.transpose()).cwiseAbs().maxCoeff() < 1e-12 * mu, kind);
    BOOST_TEST(Eigen::SelfAdjointEigenSolver<Tensor4<2>>(at.rate_tangent).eigenvalues()[0] > -1e-12 * mu,
               kind);
    const double h = 100.;  // 1/s
    for (int k = 0; k < 4; ++k) {
      const Tensor2<2> dP =
          (answer_at(*rve, F, h * unit(k)).P - answer_at(*rve, F, -h * unit(k)).P) / (2. * h);
      for (int r = 0; r < 4; ++r)
        BOOST_TEST(std::abs(dP(r / 2, r % 2) - at.rate_tangent(r, k)) < 1e-6 * mu, kind);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_smallest_acoustic_eigenvalue_is_found_with_its_band) {
  // Isotropic: shear waves, mu in every direction.
  BOOST_TEST(LeastAcoustic(isotropic(5., 2.), Tensor2<2>::Identity()).value == 2.,
             boost::test_tools::tolerance(1e-9));
  // Softer by hand against rows that slide: n = y, m = x; turned by 30 degrees with it.
  Tensor4<2> C = isotropic(5., 2.);
  C(1, 1) -= 3.;  // dP_xy/dF_xy
  const LeastAcoustic rows(C, Tensor2<2>::Identity());
  BOOST_TEST(rows.value == -1., boost::test_tools::tolerance(1e-7));
  BOOST_TEST(rows.normal == std::numbers::pi / 2., boost::test_tools::tolerance(1e-5));
  BOOST_TEST(std::abs(rows.motion) < 1e-5);
}

// The trial of general cells, reference/rve_general_cells: rows of bricks pressed along y with free sides
// slide ever more easily.
BOOST_AUTO_TEST_CASE(pressed_bricks_come_near_to_sliding) {
  const auto rve = make_rve(tissue("brick"));
  LoadingEntries entries;
  entries.path = "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.8";
  entries.found = "xx";
  entries.F_dot_by_hand = "0, 0; 0, 0";
  entries.points = 21;
  const LoadingPath path(entries);
  MixedControl control(*rve, path, {});
  const auto workspace = rve->make_workspace();
  RveState<2> state = rve->initial_state();
  double time = 0.;
  std::vector<double> found;
  for (const double next : path.times()) {
    LoadingPath::Load load;
    const RveAnswer<2> a = control.advance(state, time, next, load, *workspace);
    BOOST_REQUIRE(a.diagnostics.converged);
    state = a.trial;
    const LeastAcoustic least(elastic_tangent(*rve, a), a.trial.F);
    found.push_back(1e-3 * least.value);
    BOOST_TEST(control.stiffness() > 0.);
  }
  const std::vector<std::pair<int, double>> trial = {{2, 214.}, {5, 191.}, {10, 147.}, {15, 64.}};
  for (const auto &[percent, kilopascal] : trial)
    BOOST_TEST(found[percent] == kilopascal, boost::test_tools::tolerance(0.01));
  BOOST_TEST(found[17] > 0.);
  BOOST_TEST(found[18] < 0.);
}

BOOST_AUTO_TEST_SUITE_END()
