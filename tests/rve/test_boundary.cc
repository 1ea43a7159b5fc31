// RVEs whose boundary follows F or is pulled by one stress: at rest at F = I, stress and tangent by
// differences, and energies in the order that theory gives, softer to stiffer: traction, periodic,
// displacement.
#include "rve/make_rve.h"
#include "rve/plane_moduli.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace turgor;
using turgor::test::matrix;

namespace {
constexpr std::array<RveBoundary, 3> softer_first = {RveBoundary::uniform_traction, RveBoundary::periodic,
                                                     RveBoundary::linear_displacement};

RveParameters tissue(const std::string &kind, const RveBoundary boundary, const unsigned int n = 2,
                     const unsigned int seed = 1) {
  RveParameters p;
  p.structure.kind = choice_of<StructureKind>(kind);
  p.structure.seed = seed;
  p.columns = p.rows = n;
  p.boundary = boundary;
  p.cell.period = 100e-6;
  p.cell.nodes_per_side = 8;
  p.cell.fluid_viscosity = 0.;
  p.tolerance = 1e-11;
  return p;
}

RveAnswer<2> answer_at(const Rve<2> &rve, const Tensor2<2> &F) {
  const auto workspace = rve.make_workspace();
  RveRequest request;
  request.tangent = true;
  RveAnswer<2> a = rve.evaluate(rve.initial_state(), F, Tensor2<2>::Zero(), request, *workspace);
  BOOST_REQUIRE_MESSAGE(a.diagnostics.converged, a.diagnostics.message);
  return a;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(boundary)

BOOST_AUTO_TEST_CASE(tissue_is_at_rest_whatever_holds_its_boundary) {
  for (const std::string kind : {"square", "brick", "voronoi"})
    for (const RveBoundary held : softer_first) {
      const auto rve = make_rve(tissue(kind, held));
      const RveAnswer<2> a = answer_at(*rve, Tensor2<2>::Identity());
      BOOST_TEST(a.sigma.cwiseAbs().maxCoeff() < 1e-6 * 200e3, kind << " " << word_of(held));
      BOOST_TEST(std::abs(a.energy) < 1e-9 * 200e3);
      BOOST_TEST(PlaneModuli(a.tangent).smallest() > 0.);
    }
}

BOOST_AUTO_TEST_CASE(stress_and_tangent_are_derivatives_of_the_energy) {
  for (const std::string kind : {"brick", "voronoi"})
    for (const RveBoundary held : softer_first) {
      const auto rve = make_rve(tissue(kind, held));
      const Tensor2<2> F = matrix(1.01, 0.03, -0.01, 0.995);
      const RveAnswer<2> at = answer_at(*rve, F);
      double error[2] = {0., 0.};
      for (int level = 0; level < 2; ++level)
        for (int k = 0; k < 4; ++k) {
          const double h = level == 0 ? 1e-3 : 5e-4;
          Tensor2<2> dF = Tensor2<2>::Zero();
          dF(k / 2, k % 2) = h;
          const RveAnswer<2> plus = answer_at(*rve, F + dF), minus = answer_at(*rve, F - dF);
          if (level == 1)
            BOOST_TEST(std::abs((plus.energy - minus.energy) / (2. * h) - at.P(k / 2, k % 2)) <
                       2e-3 * at.P.norm());
          for (int r = 0; r < 4; ++r)
            error[level] = std::max(error[level],
                                    std::abs((plus.P - minus.P)(r / 2, r % 2) / (2. * h) - at.tangent(r, k)));
        }
      BOOST_TEST(error[1] < 1e-3 * at.tangent.cwiseAbs().maxCoeff());
      BOOST_TEST(std::abs(std::log2(error[0] / error[1]) - 2.) < 0.2,
                 kind << " " << word_of(held) << " " << error[0] << " " << error[1]);
      BOOST_TEST((at.tangent - at.tangent.transpose()).norm() < 1e-10 * at.tangent.norm());
      BOOST_TEST(std::abs(at.sigma(0, 1) - at.sigma(1, 0)) < 1e-6 * at.sigma.norm());
      const Tensor2<2> Q = matrix(0.8, -0.6, 0.6, 0.8);
      BOOST_TEST((answer_at(*rve, Q * F).sigma - Q * at.sigma * Q.transpose()).norm() <
                 1e-6 * at.sigma.norm());
    }
}

// At every F, stretched, pressed and sheared; the differences are no round-off.
BOOST_AUTO_TEST_CASE(energies_are_in_order) {
  const std::vector<Tensor2<2>> all = {matrix(1.02, 0., 0., 0.98), matrix(0.97, 0., 0., 1.02),
                                       matrix(1., 0.1, 0., 1.), matrix(1.01, 0., 0., 1.01),
                                       matrix(1., 0., 0.05, 0.985)};
  for (const std::string kind : {"square", "hexagon", "brick", "voronoi"})
    for (const unsigned int n : {1u, 2u, 3u}) {
      if (kind == "voronoi" && n == 1) continue;
      std::array<std::unique_ptr<Rve<2>>, 3> rves;
      for (int b = 0; b < 3; ++b) rves[b] = make_rve(tissue(kind, softer_first[b], n, 2));
      for (const Tensor2<2> &F : all) {
        std::array<double, 3> energy;
        for (int b = 0; b < 3; ++b) energy[b] = answer_at(*rves[b], F).energy;
        BOOST_TEST(energy[0] <= energy[1] * (1. + 1e-9),
                   kind << " " << n << ": " << energy[0] << " " << energy[1]);
        BOOST_TEST(energy[1] <= energy[2] * (1. + 1e-9),
                   kind << " " << n << ": " << energy[1] << " " << energy[2]);
      }
      // and so are all moduli at rest: differences of the tensors have no negative eigenvalue
      for (int b = 0; b < 2; ++b) {
        const Tensor4<2> more = answer_at(*rves[b + 1], Tensor2<2>::Identity()).tangent -
                                answer_at(*rves[b], Tensor2<2>::Identity()).tangent;
        const auto values = Eigen::SelfAdjointEigenSolver<Tensor4<2>>(more).eigenvalues();
        BOOST_TEST(values[0] > -1e-7 * 44e6, kind << " " << n << ": " << values.transpose());
        BOOST_TEST(values[3] > 1e3, kind << " " << n << ": " << values.transpose());
      }
    }
}

BOOST_AUTO_TEST_CASE(a_boundary_that_needs_walls_at_rest_says_so) {
  RveParameters p = tissue("brick", RveBoundary::uniform_traction);
  p.rule = RveRule::cauchy_born;
  BOOST_CHECK_EXCEPTION(make_rve(p), std::exception, [](const std::exception &e) {
    return std::string(e.what()).find("RVE/Boundary is uniform_traction, which needs") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
