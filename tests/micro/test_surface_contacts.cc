// Contact of deformable cells: the law by hand, slopes of energies, what is conserved, what rigid motions
// rub, what implicit steps see, lists.
#include "cortex_cell.h"
#include "micro/geometry/geodesic_sphere.h"
#include "micro/geometry/plane.h"
#include "micro/geometry/triangulated_body.h"
#include "micro/solve/motion_matrix.h"
#include "micro/terms/elastic_capsule.h"
#include "micro/terms/surface_contacts.h"
#include "micro/terms/surface_obstacles.h"
#include "slope_of_energy.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

namespace {
const SurfaceAdhesion sticky{1e-4, 0.75e-6, 0.25e-6, 3e10};

/// Two or three cells about the origin, turned against each other, so near that they touch and overlap.
struct Clump {
  ParticleSystem<3> system;
  std::shared_ptr<CellSurfaces> surfaces = std::make_shared<CellSurfaces>();
  Particles<3> &p = system.particles;

  explicit Clump(const std::vector<Vector<3>> &centres, const unsigned int nu = 4) {
    const DeformableShape shape = sphere_shape(nu, R);
    for (std::size_t c = 0; c < centres.size(); ++c) {
      const Tensor2<3> turn =
          Eigen::AngleAxisd(0.7 * double(c), Vector<3>(1., 2., double(c)).normalized()).toRotationMatrix();
      std::vector<Vector<3>> nodes;
      for (const Vector<3> &x : shape.nodes) nodes.push_back(centres[c] + turn * x);
      surfaces->add(p, shape.mesh, nodes);
    }
  }
  void shake(const double by) {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < p.size(); ++i)
        p.x[d][i] += by * (2. * random_uniform(7, 3 * i + std::uint64_t(d)) - 1.);
  }
  SurfaceContacts &touch(const double friction = 0., const SurfaceAdhesion &law = sticky) {
    return system.add(std::make_unique<SurfaceContacts>(surfaces, law, friction, 0.1e-6, 0.4e-6));
  }
  /// Net force and torque over the sums of their parts.
  std::pair<double, double> imbalance(const Particles<3>::Components &f) const {
    Vector<3> sum = Vector<3>::Zero(), torque = sum;
    double size = 0., turns = 0.;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector<3> one(f[0][i], f[1][i], f[2][i]);
      sum += one;
      torque += p.position(i).cross(one);
      size += one.norm();
      turns += p.position(i).cross(one).norm();
    }
    return {sum.norm() / size, torque.norm() / turns};
  }
};

const std::vector<Vector<3>> pair{{0., 0., 0.}, {19.6e-6, 1e-6, 2e-6}},
    three{{0., 0., 0.}, {19.6e-6, 1e-6, 2e-6}, {9e-6, 17.5e-6, 1e-6}};
}  // namespace

BOOST_AUTO_TEST_SUITE(surface_contacts)

BOOST_AUTO_TEST_CASE(law_by_hand) {
  const SurfaceAdhesion law{2e-4, 1e-6, 0.25e-6, 3e10};
  BOOST_TEST(law(0.25e-6).energy == -2e-4, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(law(0.75e-6).energy == -2e-4 * 0.75 * 0.75 * 0.75, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(law(0.75e-6).slope == 6. * 2e-4 * 0.5 * 0.75 * 0.75 / 1e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(law(0.).slope == -(3e10 + 6. * 2e-4 / 1e-12) * 0.25e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(law(1.25e-6).energy == 0.);
  BOOST_TEST(law(1.3e-6).slope == 0.);
  BOOST_TEST(law.closeness(0.1e-6) == 1.);
  BOOST_TEST(law.closeness(0.75e-6) == 0.421875, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(law.reach() == 1.25e-6, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(SurfaceAdhesion::range_for(3e-6, 20e-9) == 1.5e-6, boost::test_tools::tolerance(1e-14));
  const double h = 1e-12;
  for (const double g : {-0.3e-6, 0.1e-6, 0.4e-6, 0.9e-6, 1.2e-6}) {
    BOOST_TEST((law(g + h).energy - law(g - h).energy) / (2. * h) == law(g).slope,
               boost::test_tools::tolerance(1e-6));
    BOOST_TEST((law(g + h).slope - law(g - h).slope) / (2. * h) == law(g).curvature,
               boost::test_tools::tolerance(1e-5));
  }
}

namespace {
/// A cell against one body: slope of the energy, and the reaction on the body.
template <class Body>
void hold_to_its_energy(std::unique_ptr<Body> body) {
  Clump cell({Vector<3>(0., 0., 0.)});
  cell.shake(0.2e-6);
  auto &term =
      cell.system.add(std::make_unique<SurfaceObstacles>("body", cell.surfaces, sticky, 0., std::move(body)));
  BOOST_TEST(slope_error(cell.system, 2e-10, 3) < 1e-6);
  Vector<3> sum = term[0].force(), torque = term[0].moment() + term[0].centre.cross(sum);
  double size = 0., turns = 0.;
  for (std::size_t i = 0; i < cell.p.size(); ++i) {
    const Vector<3> f(cell.p.f[0][i], cell.p.f[1][i], cell.p.f[2][i]);
    sum += f;
    torque += cell.p.position(i).cross(f);
    size += f.norm();
    turns += cell.p.position(i).cross(f).norm();
  }
  BOOST_TEST(!term.touches(0).empty());
  BOOST_TEST(sum.norm() < 1e-12 * size);
  BOOST_TEST(torque.norm() < 1e-12 * turns);
}
}  // namespace

BOOST_AUTO_TEST_CASE(bodies_push_by_the_slope_of_the_energy_and_are_pushed_back) {
  hold_to_its_energy(std::make_unique<Plane<3>>(Vector<3>(0., 0., -9.8e-6), Vector<3>(0.1, 0.2, 1.)));
  hold_to_its_energy(
      std::make_unique<SphereSurface<3>>(Vector<3>(1e-6, 0., 0.), 10.6e-6, ParticlesAre::inside));
  hold_to_its_energy(
      std::make_unique<SphereSurface<3>>(Vector<3>(3e-6, 0., 14.7e-6), 5e-6, ParticlesAre::outside));
  const GeodesicSphere ball = make_geodesic_sphere(3);
  std::vector<Vector<3>> nodes;
  for (const Vector<3> &x : ball.positions) nodes.push_back(Vector<3>(12e-6, 2e-6, 7e-6) + 4.5e-6 * x);
  hold_to_its_energy(std::make_unique<TriangulatedBody>(ball.mesh, nodes, ParticlesAre::outside));
}

// A cell that dilates an elastic capsule: the wall gives way at once, and forces still are slopes.
BOOST_AUTO_TEST_CASE(an_elastic_capsule_gives_way) {
  Clump cell({Vector<3>(0.2e-6, 0., 0.)});
  auto &term = cell.system.add(std::make_unique<SurfaceObstacles>(
      "capsule", cell.surfaces, SurfaceAdhesion{0., 0.75e-6, 0.25e-6, 3e10}, 0.,
      std::make_unique<ElasticCapsule>(CapsuleParameters{9.7e-6, 1e-6, 5e4, 1.5, 0.})));
  BOOST_TEST(slope_error(cell.system, 2e-10, 7) < 1e-6);
  const auto &capsule = dynamic_cast<const ElasticCapsule &>(term[0]);
  BOOST_TEST(capsule.radius() > 9.75e-6);
}

// By hand: a plane through the middle of the rest gap of a flat patch cannot be made of a sphere, so: the sum
// over points of a cell all of whose surface is at one distance from a sphere about it.
BOOST_AUTO_TEST_CASE(energy_of_a_shell_by_hand) {
  Clump cell({Vector<3>(0., 0., 0.)}, 16);
  const double area = cell.surfaces->area(cell.p, 0), gap = 0.5e-6;
  cell.system.add(std::make_unique<SurfaceObstacles>(
      "sphere", cell.surfaces, sticky, 0.,
      std::make_unique<SphereSurface<3>>(Vector<3>::Zero(), R + gap, ParticlesAre::inside)));
  cell.system.compute_forces();
  BOOST_TEST(cell.system.potential_energy() == area * sticky(gap).energy, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(cells_push_by_the_slope_of_their_energy_and_conserve_both_momenta) {
  for (const auto &centres : {pair, three}) {
    Clump clump(centres);
    clump.shake(0.2e-6);
    const SurfaceContacts &term = clump.touch();
    BOOST_TEST(slope_error(clump.system, 1e-10, 3) < 1e-6);
    const auto [force, torque] = clump.imbalance(clump.p.f);
    BOOST_TEST(force < 1e-12);
    BOOST_TEST(torque < 1e-12);
    double deepest = HUGE_VAL;
    std::size_t edges_and_nodes = 0;
    for (std::size_t c = 0; c < centres.size(); ++c)
      for (const auto &t : term.touches(c)) {
        deepest = std::min(deepest, t.gap);
        edges_and_nodes += t.part[0] == 0. || t.part[1] == 0. || t.part[2] == 0.;
      }
    BOOST_TEST(deepest < 0.);
    BOOST_TEST(edges_and_nodes > 5u);
  }
}

// What a point feels does not depend on how the cells lie in space, nor on their order.
BOOST_AUTO_TEST_CASE(turned_cells_feel_the_same) {
  Clump clump(pair);
  clump.shake(0.2e-6);
  clump.touch();
  clump.system.compute_forces();
  const double energy = clump.system.potential_energy(), largest = largest_component(clump.p);
  const auto f = clump.p.f;
  const Tensor2<3> turn = Eigen::AngleAxisd(1.1, Vector<3>(3., -1., 2.).normalized()).toRotationMatrix();
  for (std::size_t i = 0; i < clump.p.size(); ++i) {
    const Vector<3> x = turn * clump.p.position(i) + Vector<3>(3e-5, -1e-5, 2e-5);
    for (int d = 0; d < 3; ++d) clump.p.x[d][i] = x[d];
  }
  clump.system.compute_forces();
  BOOST_TEST(clump.system.potential_energy() == energy, boost::test_tools::tolerance(1e-9));
  double worst = 0.;
  for (std::size_t i = 0; i < clump.p.size(); ++i) {
    const Vector<3> before(f[0][i], f[1][i], f[2][i]), now(clump.p.f[0][i], clump.p.f[1][i], clump.p.f[2][i]);
    worst = std::max(worst, (now - turn * before).norm());
  }
  BOOST_TEST(worst < 1e-8 * largest);
}

BOOST_AUTO_TEST_CASE(rigid_motions_rub_nowhere_and_friction_has_no_net_force) {
  Clump clump(three);
  clump.shake(0.2e-6);
  clump.touch(5e10);
  clump.system.compute_forces();
  MotionMatrix matrix({});
  const auto power_of = [&](const auto &velocity) {
    matrix.clear(std::vector<double>(clump.p.size(), 0.));
    clump.system.collect(matrix, 0.);
    for (std::size_t i = 0; i < clump.p.size(); ++i) {
      const Vector<3> v = velocity(i);
      for (int d = 0; d < 3; ++d) clump.p.v[d][i] = v[d];
    }
    return matrix.power<3>(clump.p.v, 1).lost;
  };
  const Vector<3> spin(0.3, -0.2, 0.5), shift(1e-6, 2e-6, -1e-6);
  const double rigid =
      power_of([&](const std::size_t i) -> Vector<3> { return shift + spin.cross(clump.p.position(i)); });
  const double apart = power_of([&](const std::size_t i) -> Vector<3> {
    return i < 162 ? Vector<3>::Zero().eval() : Vector<3>(shift + spin.cross(clump.p.position(i)));
  });
  BOOST_TEST(apart > 0.);
  BOOST_TEST(rigid < 1e-24 * apart);  // of squares: velocities to 1e-12
}

// What implicit steps see: the power of the rows with h is what friction has, plus h |w''| times the square
// of how fast gaps change.
BOOST_AUTO_TEST_CASE(rows_by_hand) {
  Clump clump(pair);
  const SurfaceContacts &term = clump.touch(0.);
  clump.system.compute_forces();
  for (std::size_t i = 0; i < clump.p.size(); ++i)
    for (int d = 0; d < 3; ++d)
      clump.p.v[d][i] = 1e-6 * (2. * random_uniform(3, 3 * i + std::uint64_t(d)) - 1.);
  MotionMatrix matrix({});
  matrix.clear(std::vector<double>(clump.p.size(), 0.));
  clump.system.collect(matrix, 2.);
  double expected = 0.;
  for (std::size_t c = 0; c < 2; ++c)
    for (const auto &t : term.touches(c)) {
      const SurfacePoints::Nodes own = term.where().nodes_of(c, t.point);
      double rate = 0.;
      for (const std::uint32_t i : own.all())
        for (int d = 0; d < 3; ++d) rate += own.share * clump.p.v[d][i] * t.normal[d];
      for (std::size_t k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d)
          rate -= t.part[k] * clump.p.v[d][clump.surfaces->triangles[t.facet][k]] * t.normal[d];
      expected += 2. * t.weight * std::abs(t.curvature) * rate * rate;
    }
  BOOST_TEST(matrix.power<3>(clump.p.v, 1).lost == expected, boost::test_tools::tolerance(1e-10));
}

// Lists: the same touches whenever they were built, and on any number of threads.
BOOST_AUTO_TEST_CASE(touches_do_not_depend_on_when_lists_were_built_nor_on_threads) {
  Clump clump(three);
  SurfaceContacts &term = clump.touch();
  clump.system.compute_forces();
  clump.shake(0.1e-6);
  clump.system.compute_forces();
  BOOST_TEST(term.near().builds() == 1u);
  const auto f = clump.p.f;
  Clump again(three);
  again.system.threads = 3;
  again.touch();
  again.p.x = clump.p.x;
  again.system.compute_forces();
  for (int d = 0; d < 3; ++d) BOOST_TEST((again.p.f[d] == f[d]));
  clump.shake(0.4e-6);
  clump.system.compute_forces();
  BOOST_TEST(term.near().builds() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
