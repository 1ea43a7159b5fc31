// Snap-through followed: a flat arch of a neo-Hookean solid, clamped at both ends, under its weight.
#include "tests/macro/tissue_fixture.h"

#include "macro/arc_length.h"
#include "run/archive.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(arc_length)

namespace {
constexpr double span = 1e-2, thick = 2e-4, rise = 6e-4, stiff = 1e6;

/// Without stress in the shape of the first evaluation: P = J0 P'(F F0^-1) F0^-T.
class ShapedLaw : public NeoHookeanLaw<2> {
 public:
  using NeoHookeanLaw<2>::NeoHookeanLaw;

  void evaluate(const std::vector<dealii::Tensor<2, 2>> &F, const std::vector<dealii::Tensor<2, 2>> &F_dot,
                const LawRequest &request, LawAnswer<2> &answer) override {
    if (shape.empty()) shape = F;
    std::vector<dealii::Tensor<2, 2>> from_there(F.size());
    for (std::size_t q = 0; q < F.size(); ++q) from_there[q] = F[q] * dealii::invert(shape[q]);
    NeoHookeanLaw<2>::evaluate(from_there, F_dot, request, answer);
    for (std::size_t q = 0; q < F.size(); ++q) {
      const dealii::Tensor<2, 2> back = dealii::invert(shape[q]);
      const double J = dealii::determinant(shape[q]);
      answer.P[q] = J * answer.P[q] * dealii::transpose(back);
      answer.energy[q] *= J;
      if (!request.tangents) continue;
      dealii::Tensor<4, 2> A;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          for (unsigned int k = 0; k < 2; ++k)
            for (unsigned int l = 0; l < 2; ++l)
              for (unsigned int m = 0; m < 2; ++m)
                for (unsigned int n = 0; n < 2; ++n)
                  A[i][j][k][l] += J * answer.tangent[q][i][m][k][n] * back[j][m] * back[l][n];
      answer.tangent[q] = A;
    }
  }

 private:
  std::vector<dealii::Tensor<2, 2>> shape;
};

struct Arch {
  Arch() : law(stiff, stiff, 0., rho), tissue(parameters(), law) {
    const TissueMesh<2> &mesh = tissue.mesh();
    for (unsigned int a = 0; a < mesh.nodes; ++a) {
      const double s = std::sin(3.14159265358979323846 * mesh.node_position[a][0] / span);
      tissue.state().u[2 * a + 1] = mesh.clamped[a] ? 0. : rise * s * s;
      if (std::abs(mesh.node_position[a][0] - 0.5 * span) < 1e-9 && mesh.node_position[a][1] > 0.9 * thick)
        crown = a;
    }
    tissue.forces().evaluate(0., 0., tissue.state().u, std::vector<double>(tissue.forces().size(), 0.), true);
  }

  static TissueParameters<2> parameters() {
    TissueParameters<2> p;
    p.size = {span, thick};
    p.elements = {16, 1};
    p.degree = 2;
    p.locking = Locking::full;
    p.right = RightSide::clamped;
    p.body_force[1] = -500.;
    return p;
  }

  double height() const { return tissue.state().u[2 * crown + 1]; }

  ShapedLaw law;
  Tissue<2> tissue;
  unsigned int crown = 0;
};

ArcLengthSettings settings() {
  ArcLengthSettings s;
  s.first_share = 0.02;
  s.longest = 2e-5;
  s.newton.tolerance = 1e-8;
  return s;
}
}  // namespace

BOOST_AUTO_TEST_CASE(an_arch_snaps_through_and_its_energy_is_its_works) {
  Arch arch;
  ArcLength<2> path(arch.tissue, settings());
  double most = 0., least = 1e300, top_height = 0., low_height = 0., worst_gap = 0., work = 0.;
  bool down = false;
  while (arch.height() > -1.3 * rise && path.counters().steps < 400) {
    path.step();
    if (!down && path.share() > most) {
      most = path.share();
      top_height = arch.height();
    }
    if (path.share() < most) down = true;
    if (down && path.share() < least) {
      least = path.share();
      low_height = arch.height();
    }
    worst_gap = std::max(worst_gap, std::abs(path.energies().gap()));
    work = std::max(work, path.energies().work);
  }
  BOOST_TEST_MESSAGE(path.counters().steps
                     << " steps, " << path.counters().iterations << " iterations: up to " << most
                     << " of the load at height " << top_height / rise << " of the rise, down to " << least
                     << " at " << low_height / rise << ", then up to " << path.share() << "; energy off by "
                     << worst_gap);
  BOOST_TEST(arch.height() < -1.29 * rise);
  BOOST_TEST(down);
  BOOST_TEST(least < 0.8 * most);
  BOOST_TEST(path.share() > most);
  BOOST_TEST(worst_gap < 1e-3);  // on the whole way: elastic, so work is energy whatever the path

  // load steps find the same limit: stable below, and above only after a jump to the branch beyond
  for (const double factor : {0.99, 1.01}) {
    Arch again;
    TissueState<2> &state = again.tissue.state();
    StaticBalance<2> balance(again.tissue.forces(), {});
    NewtonSettings n;
    n.tolerance = 1e-8;
    StaticNewton<2> newton(balance, n);
    for (int k = 1; k <= 40; ++k) {
      std::vector<double> u = state.u;
      const LoadPlace place{0., 0., factor * most * k / 40};
      BOOST_REQUIRE(newton.solve(u, place) || (u = state.u, newton.dragged(u, place).found));
      state.u = u;
    }
    BOOST_TEST_MESSAGE("load steps to " << factor << " of the limit: height " << again.height() / rise);
    BOOST_TEST((again.height() > 0.) == (factor < 1.));
  }
}

BOOST_AUTO_TEST_CASE(its_newton_is_quadratic_and_it_goes_on_from_its_archive) {
  Arch arch, again;
  ArcLength<2> path(arch.tissue, settings()), resumed(again.tissue, settings());
  unsigned int seen = 0;
  for (int k = 0; k < 12; ++k) {
    if (k == 6) restore(archived(path), resumed);
    path.step();
    const std::vector<double> &r = path.residuals();
    const std::size_t n = r.size();
    if (n < 3 || !(r[n - 2] < 1e-2) || !(r[n - 2] > 1e-6)) continue;
    ++seen;
    BOOST_TEST(r[n - 1] < 1e3 * r[n - 2] * r[n - 2] + 1e-10, r[n - 2] << " " << r[n - 1]);
  }
  BOOST_TEST(seen >= 3u);
  for (int k = 6; k < 12; ++k) resumed.step();
  BOOST_TEST((arch.tissue.state().u == again.tissue.state().u));
  BOOST_TEST(path.share() == resumed.share());
}

BOOST_AUTO_TEST_CASE(what_it_cannot_follow_is_refused) {
  TissueParameters<2> p = gravity(2);
  p.body_force[1] = 0.;
  NeoHookeanLaw<2> law(mu, lambda, 0., rho);
  Tissue<2> tissue(p, law);
  BOOST_CHECK_EXCEPTION(ArcLength<2>(tissue, {}), std::invalid_argument, [](const std::invalid_argument &e) {
    return std::string(e.what()).find("needs a load") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
