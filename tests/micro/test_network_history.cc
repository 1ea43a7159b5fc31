// Walls that have flowed and broken, cells that have failed: forces and Hessian by differences, potentials,
// dissipation, packing.
#include "micro/cells/network_equilibrium.h"
#include "micro/cells/parenchyma.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace turgor;

namespace {
struct Torn {
  HydrostaticNetwork network;
  WallHistory history;
  std::vector<double> x;
  Tensor2<2> H;

  static CellLayout patch() {
    ParenchymaParameters p;
    p.nodes_per_side = 5;
    p.wall_yield = {15., 0.9};
    CellLayout layout = make_parenchyma(p, 2, 2, true, true);
    layout.fluid_mass.assign(4, 1000. * 1e-4 * 1e-4 * 50e-6);
    return layout;
  }
  static WallLimits limits() {
    WallLimits l;
    l.plastic = true;
    l.critical_stretch = 1.3;
    l.residue = 0.9;
    return l;
  }

  // Bonds stretched by up to 20 %, flowed to random stretches about that, some broken; one cell failed and
  // half empty.
  Torn() : network(patch()) {
    network.set_limits(limits());
    Tensor2<2> F;
    F << 1.1, 0.1, -0.02, 0.99;
    H = F * network.layout().lattice;
    x = network.layout().positions();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-0.1, 0.1), stretch(1., 1.25);
    for (std::size_t i = 0; i < x.size(); i += 2) {
      const Vector<2> at = F * Vector<2>(x[i], x[i + 1]);
      x[i] = at[0] + shift(random) * network.layout().spacing;
      x[i + 1] = at[1] + shift(random) * network.layout().spacing;
    }
    history = network.new_history(network.layout().positions());
    std::vector<double> numbers = history.pack();
    for (std::size_t i = 0; i < history.reached.size(); ++i) numbers[2 + i] = stretch(random);
    network.unpack(numbers, history);
    for (const std::size_t bond : {3u, 7u, 8u}) history.broken[bond] = 1;
    history.failed[0] = 1;
    history.mass[0] *= 0.7;
    history.pressure_share = 0.6;
  }
  double energy(const std::vector<double> &at) const {
    NetworkEvaluation e;
    network.evaluate(at, H, NetworkOrder::energy, e, &history);
    return e.energy;
  }
};

const NeoHookeanWall loaded(100., 50e-6, 0.5, {15., 0.9}), elastic = loaded.elastic();
}  // namespace

BOOST_AUTO_TEST_SUITE(network_history)

BOOST_AUTO_TEST_CASE(force_is_minus_potential_slope) {
  const Torn torn;
  NetworkEvaluation e;
  torn.network.evaluate(torn.x, torn.H, NetworkOrder::gradient, e, &torn.history);
  std::vector<double> x = torn.x;
  const double h = 1e-5 * torn.network.layout().spacing;
  double worst = 0., scale = 0.;
  for (std::size_t d = 0; d < x.size(); ++d) {
    const double kept = x[d];
    x[d] = kept + h;
    const double up = torn.energy(x);
    x[d] = kept - h;
    const double down = torn.energy(x);
    x[d] = kept;
    worst = std::max(worst, std::abs((up - down) / (2. * h) - e.gradient[d]));
    scale = std::max(scale, std::abs(e.gradient[d]));
  }
  // h/spacing at the kink where flow starts, and round-off 1e-16/1e-5
  BOOST_TEST(worst < 1e-5 * scale, "largest difference " << worst << " N of " << scale << " N");
}

BOOST_AUTO_TEST_CASE(hessian_is_force_slope) {
  const Torn torn;
  NetworkEquilibrium equilibrium(torn.network);
  equilibrium.set_history(&torn.history);
  const Eigen::MatrixXd A = equilibrium.system(torn.x, torn.H);
  const Eigen::Index n = Eigen::Index(torn.x.size()) - 2;
  const Eigen::MatrixXd K = A.topLeftCorner(n, n) +
                            A.topRightCorner(n, A.cols() - n) * A.topRightCorner(n, A.cols() - n).transpose();
  std::vector<double> x = torn.x;
  const double h = 1e-6 * torn.network.layout().spacing;
  double worst = 0.;
  NetworkEvaluation up, down;
  for (Eigen::Index d = 0; d < n; ++d)  // node 0 is pinned
  {
    const double kept = x[d + 2];
    x[d + 2] = kept + h;
    torn.network.evaluate(x, torn.H, NetworkOrder::gradient, up, &torn.history);
    x[d + 2] = kept - h;
    torn.network.evaluate(x, torn.H, NetworkOrder::gradient, down, &torn.history);
    x[d + 2] = kept;
    for (Eigen::Index r = 0; r < n; ++r)
      worst = std::max(worst, std::abs((up.gradient[r + 2] - down.gradient[r + 2]) / (2. * h) - K(r, d)));
  }
  BOOST_TEST(worst < 1e-4 * K.cwiseAbs().maxCoeff(), worst << " of " << K.cwiseAbs().maxCoeff());
}

// By hand: a bond brought to lambda flows so far that its elastic force there is the yield curve's; back at
// lambda_p it is slack.
BOOST_AUTO_TEST_CASE(a_bond_flows_along_the_curve_and_springs_back) {
  WallHistory h;
  h.reached = {1.};
  h.permanent = {1.};
  double slope, dissipated = 0., work = 0., last = 0.;
  for (int i = 1; i <= 200; ++i) {
    const double lambda = 1. + 0.001 * i, F = h.force(loaded, elastic, 1e-3, 0, lambda, slope);
    BOOST_TEST(F == loaded.force(lambda),
               boost::test_tools::tolerance(
                   1e-12));  // the two overloads round differently, where the force is small more
    work += 0.0005 * (F + last);
    last = F;
    const double more = h.flow(loaded, elastic, 0, lambda);
    BOOST_TEST(more >= 0.);
    dissipated += more;
    BOOST_TEST(elastic.force(lambda / h.permanent[0]) == F, boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(h.permanent[0] > 1.);
  BOOST_TEST(std::abs(h.force(loaded, elastic, 1e-3, 0, h.permanent[0], slope)) < 1e-15);
  BOOST_TEST(h.force(loaded, elastic, 1e-3, 0, 0.999 * h.permanent[0], slope) < 0.);
  // work done = stored + dissipated; 1e-4: the trapezoidal rule in 200 steps
  BOOST_TEST(work == dissipated + h.stored(loaded, elastic, 1e-3, 0, 1.2),
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(h.stored(loaded, elastic, 1e-3, 0, h.permanent[0]) < 1e-12 * work);
  // in one go as in 200
  WallHistory once;
  once.reached = {1.};
  once.permanent = {1.};
  BOOST_TEST(once.flow(loaded, elastic, 0, 1.2) == dissipated, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(once.permanent[0] == h.permanent[0], boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(packed_and_unpacked) {
  const Torn torn;
  WallHistory other = torn.network.new_history(torn.network.layout().positions());
  torn.network.unpack(torn.history.pack(), other);
  BOOST_TEST((other.reached == torn.history.reached));
  BOOST_TEST((other.permanent == torn.history.permanent));
  BOOST_TEST((other.broken == torn.history.broken));
  BOOST_TEST((other.failed == torn.history.failed));
  BOOST_TEST((other.mass == torn.history.mass));
  std::vector<double> numbers = torn.history.pack();
  numbers.pop_back();
  BOOST_CHECK_THROW(torn.network.unpack(numbers, other), std::invalid_argument);
  BOOST_TEST(WallHistory().pack().empty());
}

BOOST_AUTO_TEST_CASE(limits_say_what_is_allowed) {
  const auto fails = [](WallLimits limits, const WallYield &yield, const char *entry) {
    BOOST_CHECK_EXCEPTION(limits.check(yield), std::invalid_argument, [&](const auto &e) {
      return std::string(e.what()).find(entry) != std::string::npos;
    });
  };
  WallLimits l;
  l.plastic = true;
  fails(l, {}, "Yield drop");
  l = {};
  l.critical_stretch = 0.8;
  fails(l, {}, "Critical stretch");
  l = {};
  l.leak_time = -1.;
  fails(l, {}, "Leak time");
  l = {};
  l.residue = 1.;
  fails(l, {}, "Residue");
}

BOOST_AUTO_TEST_SUITE_END()
