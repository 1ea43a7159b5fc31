// Air spaces of sparse tissue: where they are, contact across them, and the reference at turgor.
#include "micro/cells/air_spaces.h"
#include "micro/cells/network_equilibrium.h"
#include "micro/cells/tiled_layout.h"
#include "micro/cells/tissue_structure.h"
#include "micro/cells/turgid_layout.h"
#include "micro/engine/particle_system.h"
#include "micro/geometry/regular_tilings.h"
#include "micro/laws/counter_random.h"
#include "micro/laws/face_contact.h"
#include "micro/terms/cell_contact.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace turgor;

namespace {
constexpr double L = 100e-6, gap = 20e-6;

ParenchymaParameters cell_of(const unsigned int nodes_per_side) {
  ParenchymaParameters p;
  p.period = L;
  p.nodes_per_side = nodes_per_side;
  p.lamella_ratio = 1.;
  return p;
}

TissueStructure sparse(const StructureKind kind) {
  TissueStructure structure;
  structure.kind = kind;
  structure.gap = gap;
  return structure;
}

/// Sparse bricks whose air spaces are nearly closed: walls touch everywhere.
struct Touching {
  HydrostaticNetwork network;
  std::vector<double> x;
  Tensor2<2> H;

  explicit Touching(const unsigned int n)
      : network(turgid_tissue(sparse(StructureKind::brick), cell_of(12), n, n)),
        x(network.layout().positions()) {
    NetworkEquilibrium equilibrium(network);
    Tensor2<2> last = Tensor2<2>::Identity();
    for (const double height : {0.98, 0.96, 0.94, 0.92, 0.9}) {
      Tensor2<2> F;
      F << 1.01, 0.03, -0.01, height;
      H = F * network.layout().lattice;
      const Tensor2<2> step = F * last.inverse();
      for (std::size_t i = 0; i < x.size(); i += 2) {
        const Vector<2> moved = step * Vector<2>(x[i], x[i + 1]);
        x[i] = moved[0];
        x[i + 1] = moved[1];
      }
      BOOST_REQUIRE(equilibrium.solve(x, H, {}).converged);
      last = F;
    }
    for (std::size_t d = 0; d < x.size(); ++d) x[d] += 0.05e-6 * (random_uniform(3, d) - 0.5);
  }
  double energy(const std::vector<double> &at, const Tensor2<2> &lattice) const {
    NetworkEvaluation e;
    network.evaluate(at, lattice, NetworkOrder::energy, e);
    return e.energy;
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(air_spaces)

BOOST_AUTO_TEST_CASE(a_point_against_a_face_has_the_derivatives_of_its_energy) {
  const FaceContact law{1e-6, 1.2e-6, 3e-6, 4e8};
  for (const auto &[at, offset] : {std::pair{0.4, 1e-6}, {0.4, -0.7e-6}, {0., 0.5e-6}, {1., 1.2e-6}}) {
    FaceContact::Seven x = {Vector<2>(12e-6, 6e-6), {5e-6, 1e-6},  {-4e-6, 7e-6}, {-8e-6, -3e-6}, {0., 0.},
                            {9e-6, 1e-6},           {16e-6, -4e-6}};
    // the face runs to the right: its cell lies above it
    for (Vector<2> &v : x) v *= -1.;
    const auto energy = [&](const FaceContact::Seven &places) {
      const Vector<2> p = law.face(places[0], places[1], places[2]),
                      line[2] = {law.face(places[3], places[4], places[5]),
                                 law.face(places[4], places[5], places[6])};
      return law.energy(FaceContact::nearest(p, line, 2).distance);
    };
    // the point to where the foot and the distance are as wanted
    const Vector<2> a = law.face(x[3], x[4], x[5]), b = law.face(x[4], x[5], x[6]), u = (b - a).normalized();
    const Vector<2> normal(u[1], -u[0]), wanted = a + at * (b - a) + offset * normal +
                                                  (at == 0.   ? -0.4e-6
                                                   : at == 1. ? 0.4e-6
                                                              : 0.) *
                                                      u;
    const Vector<2> move = wanted - law.face(x[0], x[1], x[2]);
    for (std::size_t k = 0; k < 3; ++k) x[k] += move;
    const Vector<2> line[2] = {a, b};
    const FaceContact::Foot foot = FaceContact::nearest(wanted, line, 2);
    BOOST_TEST(foot.t == at, boost::test_tools::tolerance(1e-6));
    BOOST_TEST((foot.distance > 0.) == (offset > 0.));

    FaceContact::Vector14 g, ahead, behind;
    FaceContact::Matrix14 h;
    law.derivatives(x, foot, g, &h);
    const double step = 1e-11;
    const auto gradient_at = [&](const FaceContact::Seven &places, FaceContact::Vector14 &to) {
      const Vector<2> two[2] = {law.face(places[3], places[4], places[5]),
                                law.face(places[4], places[5], places[6])};
      law.derivatives(places, FaceContact::nearest(law.face(places[0], places[1], places[2]), two, 2), to,
                      nullptr);
    };
    for (std::size_t d = 0; d < 14; ++d) {
      FaceContact::Seven up = x, down = x;
      up[d / 2][Eigen::Index(d % 2)] += step;
      down[d / 2][Eigen::Index(d % 2)] -= step;
      const double slope = (energy(up) - energy(down)) / (2. * step);
      BOOST_TEST(std::abs(slope - g[Eigen::Index(d)]) < 1e-6 * g.cwiseAbs().maxCoeff());
      gradient_at(up, ahead);
      gradient_at(down, behind);
      const FaceContact::Vector14 column = (ahead - behind) / (2. * step);
      BOOST_TEST((column - h.col(Eigen::Index(d))).cwiseAbs().maxCoeff() < 1e-6 * h.cwiseAbs().maxCoeff());
    }
    BOOST_TEST((h - h.transpose()).cwiseAbs().maxCoeff() < 1e-14 * h.cwiseAbs().maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(there_is_one_where_cells_meet) {
  const auto spaces = [](const Tiling &t, const double g) { return lay_cells(t, cell_of(12), g).air; };
  BOOST_TEST(spaces(replicated(brick_tiling(L), 2, 2), 0.).empty());
  for (const unsigned int n : {1u, 2u}) {
    for (const Tiling &three : {brick_tiling(L), hexagon_tiling(L)}) {
      const auto air = spaces(replicated(three, n, n), gap);
      BOOST_TEST(air.size() == 2u * n * n);
      for (const AirSpace &space : air) BOOST_TEST(space.size() == 3u);
    }
    const auto four = spaces(replicated(square_tiling(L), n, n), gap);
    BOOST_TEST(four.size() == std::size_t(n) * n);
    for (const AirSpace &space : four) BOOST_TEST(space.size() == 4u);
  }
  BOOST_CHECK_THROW(spaces(square_tiling(L), 0.6 * L), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(area_of_air_and_cells_is_that_of_the_period) {
  for (const StructureKind kind : {StructureKind::brick, StructureKind::hexagon, StructureKind::square}) {
    const CellLayout layout = turgid_tissue(sparse(kind), cell_of(12), 1, 1);
    const HydrostaticNetwork network(layout);
    NetworkEvaluation e;
    network.evaluate(layout.positions(), layout.lattice, NetworkOrder::gradient, e);
    const double period = layout.lattice.determinant(), cell = e.volume[0] / network.depth(),
                 share = network.air_share(layout.positions(), layout.lattice);
    double air = 0.;
    for (const AirSpace &space : layout.air)
      air += air_area(layout, space, layout.positions(), layout.lattice);
    BOOST_TEST(share == 1. - cell / period, boost::test_tools::tolerance(1e-12));
    BOOST_TEST_MESSAGE(word_of(kind) << ": air " << air / period << ", period "
                                     << layout.lattice.col(0).norm() << " x " << layout.lattice(1, 1));
    BOOST_TEST(air > 0.05 * period);
    // ties give way a little
    BOOST_TEST(std::abs(period - cell - air) < 2e-3 * period);
  }
}

BOOST_AUTO_TEST_CASE(touching_walls_have_the_derivatives_of_their_energy) {
  const Touching t(1);
  NetworkEvaluation e;
  t.network.evaluate(t.x, t.H, NetworkOrder::hessian, e);
  BOOST_TEST_MESSAGE(e.touches.size() << " touch");
  BOOST_REQUIRE(e.touches.size() > 4u);
  const double largest =
      std::abs(*std::max_element(e.gradient.begin(), e.gradient.end(),
                                 [](const double a, const double b) { return std::abs(a) < std::abs(b); }));
  NetworkEquilibrium equilibrium(t.network);
  const Eigen::MatrixXd K = equilibrium.system(t.x, t.H);
  const Eigen::Index free = Eigen::Index(t.x.size()) - 2;
  const double step = 2e-11;
  double worst = 0., worst_second = 0.;
  for (std::size_t d = 0; d < t.x.size(); ++d) {
    std::vector<double> up = t.x, down = t.x;
    up[d] += step;
    down[d] -= step;
    worst =
        std::max(worst, std::abs((t.energy(up, t.H) - t.energy(down, t.H)) / (2. * step) - e.gradient[d]));
    if (d < 2) continue;
    NetworkEvaluation ahead, behind;
    t.network.evaluate(up, t.H, NetworkOrder::gradient, ahead);
    t.network.evaluate(down, t.H, NetworkOrder::gradient, behind);
    for (Eigen::Index i = 0; i < free; ++i) {
      // K + b b^T: node 0 is held, rows of the cell's q are the last
      const Eigen::Index j = Eigen::Index(d) - 2;
      const double second = K(i, j) + K(i, free) * K(j, free),
                   difference = (ahead.gradient[std::size_t(i) + 2] - behind.gradient[std::size_t(i) + 2]) /
                                (2. * step);
      worst_second = std::max(worst_second, std::abs(second - difference));
    }
  }
  BOOST_TEST_MESSAGE("gradient " << worst / largest << ", Hessian "
                                 << worst_second / K.cwiseAbs().maxCoeff());
  BOOST_TEST(worst < 1e-6 * largest);
  BOOST_TEST(worst_second < 2e-8 * K.cwiseAbs().maxCoeff());
}

// Strips of particles cut out of such tissue push with the same law: the same energy, forces and stress in
// the same places, as long as no wall has been carried through another.
BOOST_AUTO_TEST_CASE(walls_of_particles_touch_alike) {
  const Touching t(1);
  const CellLayout &layout = t.network.layout();
  NetworkEvaluation e;
  t.network.evaluate(t.x, t.H, NetworkOrder::gradient, e);
  const AirContact &air = t.network.air_contact();
  std::vector<double> expected(t.x.size(), 0.);
  Tensor2<2> virial = Tensor2<2>::Zero();
  air.add_forces(e.touches, expected, virial);

  ParticleSystem<2> system;
  Particles<2> &p = system.particles;
  p.resize(layout.nodes.size());
  for (const WallRing &ring : layout.rings)
    p.groups.push_back({ring.first, std::uint32_t(ring.end()), std::uint32_t(ring.end())});
  for (std::size_t i = 0; i < t.x.size(); ++i) p.x[i % 2][i / 2] = t.x[i];
  system.box.H = t.H;
  system.box.periodic = {true, true};
  CellContactParameters parameters;
  parameters.soft = true;
  parameters.surface = {air.law().inset, air.law().smooth};
  parameters.range = air.law().range;
  parameters.stiffness = air.law().stiffness * air.law().range;
  parameters.skin = 0.5 * layout.spacing;
  parameters.spacing = layout.spacing;
  parameters.node_mass = layout.node_mass[0];
  system.add(std::make_unique<CellContact>(parameters));
  system.compute_forces();
  const double energy = air.energy(t.x, t.H);
  BOOST_REQUIRE(energy > 0.);
  BOOST_TEST(system.potential_energy() == energy, boost::test_tools::tolerance(1e-9));
  double worst = 0., largest = 0.;
  for (std::size_t i = 0; i < t.x.size(); ++i) {
    worst = std::max(worst, std::abs(p.f[i % 2][i / 2] + expected[i]));
    largest = std::max(largest, std::abs(expected[i]));
  }
  BOOST_TEST(worst < 1e-9 * largest);
  BOOST_TEST((system.virial() - virial).cwiseAbs().maxCoeff() < 1e-9 * virial.cwiseAbs().maxCoeff());
}

BOOST_AUTO_TEST_CASE(touching_walls_follow_the_lattice_exactly) {
  const Touching t(1);
  std::array<Tensor2<2>, 4> L_of;
  for (int k = 0; k < 4; ++k) {
    L_of[std::size_t(k)].setZero();
    L_of[std::size_t(k)](k / 2, k % 2) = 1.;
  }
  const auto moved = [&](const Tensor2<2> &A) {
    std::vector<double> x = t.x;
    for (std::size_t i = 0; i < x.size(); i += 2) {
      const Vector<2> v = A * Vector<2>(x[i], x[i + 1]);
      x[i] = v[0];
      x[i + 1] = v[1];
    }
    return x;
  };
  NetworkEvaluation e, ahead, behind;
  t.network.evaluate(t.x, t.H, NetworkOrder::hessian, e);
  std::array<std::vector<double>, 4> forces;
  Tensor4<2> curvature;
  t.network.affine_response(t.x, t.H, e, L_of, forces, curvature);
  const double step = 1e-6;
  const Tensor2<2> I = Tensor2<2>::Identity(), virial = e.virial.total();
  for (int k = 0; k < 4; ++k) {
    const Tensor2<2> A = I + step * L_of[std::size_t(k)], B = I - step * L_of[std::size_t(k)];
    const std::vector<double> up = moved(A), down = moved(B);
    const double slope = (t.energy(up, A * t.H) - t.energy(down, B * t.H)) / (2. * step);
    BOOST_TEST(std::abs(slope - virial(k / 2, k % 2)) < 1e-6 * virial.cwiseAbs().maxCoeff());
    t.network.evaluate(up, A * t.H, NetworkOrder::gradient, ahead);
    t.network.evaluate(down, B * t.H, NetworkOrder::gradient, behind);
    double worst = 0., largest = 0.;
    for (std::size_t d = 0; d < t.x.size(); ++d) {
      const double f = forces[std::size_t(k)][d];
      worst = std::max(worst, std::abs((ahead.gradient[d] - behind.gradient[d]) / (2. * step) - f));
      largest = std::max(largest, std::abs(f));
    }
    BOOST_TEST(worst < 2e-8 * largest);
    // along the motion x -> (I + s L) x the virial is that of the place: dE/dL = virial (I + s L)^-T
    const Tensor2<2> change =
        (ahead.virial.total() * A.inverse().transpose() - behind.virial.total() * B.inverse().transpose()) /
        (2. * step);
    for (int l = 0; l < 4; ++l)
      BOOST_TEST(std::abs(change(l / 2, l % 2) - curvature(l, k)) < 2e-8 * curvature.cwiseAbs().maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(at_turgor_no_stress_is_left) {
  for (const StructureKind kind : {StructureKind::brick, StructureKind::hexagon, StructureKind::square})
    for (const unsigned int n : {1u, 2u}) {
      TurgidSearch how;
      const CellLayout laid = laid_tissue(sparse(kind), cell_of(12), n, n);
      const CellLayout turgid = turgid_with_lattice(laid, &how);
      BOOST_TEST_MESSAGE(word_of(kind) << ' ' << n << ": " << how.iterations << " iterations, "
                                       << how.lattice_steps << " of the lattice, stress " << how.stress);
      BOOST_TEST(how.stress < 1e-9 * laid.parameters.turgor);
    }
}

BOOST_AUTO_TEST_SUITE_END()
