// Particles against bodies of any shape: distances by hand and by brute force, F = -dE/dx, momentum, work
// against energy, the same bits always.
#include "micro/engine/kick_drift_kick.h"
#include "micro/engine/particle_system.h"
#include "micro/engine/respa.h"
#include "micro/geometry/geodesic_sphere.h"
#include "micro/geometry/plane.h"
#include "micro/geometry/triangulated_body.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/obstacles.h"
#include "tests/micro/slope_of_energy.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <numbers>

using namespace turgor;

namespace {
constexpr double pi = std::numbers::pi;
const auto digits = [](const double relative) { return boost::test_tools::tolerance(relative); };

/// Wall particles of groups of `each`, 1 kg each, no other force.
template <int dim>
void put(ParticleSystem<dim> &system, const std::vector<Vector<dim>> &positions,
         const std::size_t each = 1000000) {
  Particles<dim> &p = system.particles;
  const std::uint32_t n = std::uint32_t(positions.size());
  p.resize(n);
  p.groups.clear();
  for (std::uint32_t i = 0; i < n; i += std::uint32_t(each))
    p.groups.push_back({i, std::uint32_t(std::min<std::size_t>(n, i + each)),
                        std::uint32_t(std::min<std::size_t>(n, i + each))});
  for (std::uint32_t i = 0; i < n; ++i) {
    p.inverse_mass[i] = 1.;
    for (int d = 0; d < dim; ++d) p.x[d][i] = positions[i][d];
  }
}

/// The same as spheres of cells: no wall nodes, R = 0.3 ... 0.4 m.
void make_spheres(Particles<3> &p) {
  p.declare("radius");
  p.declare("modulus");
  for (Group &g : p.groups) g.fluid = g.begin;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.field("radius")[i] = 0.3 + 0.1 * random_uniform(4, i);
    p.field("modulus")[i] = 100. + 50. * random_uniform(5, i);
  }
}

template <int dim>
Vector<dim> random_vector(const std::uint64_t i) {
  Vector<dim> x;
  for (int d = 0; d < dim; ++d) x[d] = 2. * random_uniform(9, dim * i + std::uint64_t(d)) - 1.;
  return x;
}

template <int dim>
std::vector<Vector<dim>> cloud(const std::size_t n, const double half_width) {
  std::vector<Vector<dim>> x;
  for (std::size_t i = 0; i < n; ++i) x.push_back(half_width * random_vector<dim>(i));
  return x;
}

template <int dim>
Obstacles<dim> &two_plates(ParticleSystem<dim> &system, const double stiffness, const double low,
                           const double high) {
  const Vector<dim> up = Vector<dim>::Unit(dim - 1);
  return system.add(std::make_unique<Obstacles<dim>>("plates", SurfacePenalty{stiffness},
                                                     std::make_unique<Plane<dim>>(low * up, up),
                                                     std::make_unique<Plane<dim>>(high * up, -up)));
}

/// A cube |x| < 1/2 of twelve triangles.
TriangleMesh cube_mesh() {
  TriangleMesh mesh;  // node bits: x, y, z
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

std::vector<Vector<3>> cube_nodes(const Vector<3> &centre = Vector<3>::Zero()) {
  std::vector<Vector<3>> nodes;
  for (int k = 0; k < 8; ++k)
    nodes.push_back(centre + Vector<3>((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5));
  return nodes;
}

/// A ball with five blunt horns and dents: not convex.
GeodesicSphere horned() {
  GeodesicSphere ball = make_geodesic_sphere(5);
  for (Vector<3> &x : ball.positions)
    x *= 1. + 0.35 * std::sin(5. * std::atan2(x[1], x[0])) * (1. - x[2] * x[2]) + 0.1 * x[2];
  return ball;
}

std::unique_ptr<TriangulatedBody> horned_body(const ParticlesAre side) {
  const GeodesicSphere ball = horned();
  return std::make_unique<TriangulatedBody>(ball.mesh, ball.positions, side);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(obstacles)

BOOST_AUTO_TEST_CASE(force_and_energy_of_plates_by_hand) {
  ParticleSystem<3> system;
  put<3>(system, {{0., 0., -0.1}, {0., 0., 0.05}, {0., 0., 1.2}});
  // Floor at z = 0, lid at z = 1, k = 10 N/m: depths 0.1 below the floor, 0.2 above the lid.
  const Obstacles<3> &two = two_plates(system, 10., 0., 1.);
  system.compute_forces();
  BOOST_TEST(system.particles.f[2][0] == 1., digits(1e-14));
  BOOST_TEST(system.particles.f[2][1] == 0.);
  BOOST_TEST(system.particles.f[2][2] == -2., digits(1e-14));
  BOOST_TEST(two[0].pressing() == 1., digits(1e-14));
  BOOST_TEST(two[1].pressing() == 2., digits(1e-14));
  BOOST_TEST(two[1].force()[2] == 2., digits(1e-14));
  BOOST_TEST(two.deepest() == 0.2, digits(1e-14));
  BOOST_TEST(system.potential_energy() == 0.5 * 10. * (0.01 + 0.04), digits(1e-14));
  BOOST_TEST(system.particles.f[0][0] == 0.);  // no friction
}

BOOST_AUTO_TEST_CASE(distances_to_spheres_by_hand) {
  const SphereSurface<3> in({1., 0., 0.}, 2., ParticlesAre::inside),
      out({1., 0., 0.}, 2., ParticlesAre::outside);
  const Vector<3> x(1., 1.5, 0.);
  BOOST_TEST(in.at(x).distance == 0.5, digits(1e-14));
  BOOST_TEST(in.at(x).normal[1] == -1., digits(1e-14));
  BOOST_TEST(in.at(x).curvature == -0.5);
  BOOST_TEST(out.at(x).distance == -0.5, digits(1e-14));
  BOOST_TEST(out.at(x).normal[1] == 1., digits(1e-14));
  BOOST_TEST(out.at(x).curvature == 0.5);
  BOOST_TEST(in.at(x, 0.4).distance == HUGE_VAL);  // farther than asked for
  BOOST_TEST(out.at({1., 3., 0.}, 0.9).distance == HUGE_VAL);
  BOOST_TEST(out.at({1., 3., 0.}, 1.1).distance == 1., digits(1e-14));
}

// Faces, edges and corners of a cube, from both sides; turned by a quarter and carried along.
BOOST_AUTO_TEST_CASE(distances_to_a_cube_by_hand) {
  using Feature = TriangulatedBody::Feature;
  TriangulatedBody cube(cube_mesh(), cube_nodes(), ParticlesAre::outside);
  const auto check = [&](const Vector<3> &x, const double distance, const Vector<3> &normal,
                         const Feature feature) {
    const auto c = cube.at(x);
    BOOST_TEST(c.distance == distance, digits(1e-13));
    BOOST_CHECK_SMALL((c.normal - normal).norm(), 1e-13);
    BOOST_TEST(int(c.feature) == int(feature));
  };
  const double s = std::sqrt(0.5), t = std::sqrt(1. / 3.);
  check({0.1, 0.2, 0.8}, 0.3, {0., 0., 1.}, Feature::face);
  check({0.1, 0.2, 0.4}, -0.1, {0., 0., 1.}, Feature::face);
  check({0.8, 0.2, 0.8}, 0.3 / s, {s, 0., s}, Feature::edge);
  check({0.8, 0.8, 0.8}, 0.3 / t, {t, t, t}, Feature::vertex);
  check({0.1, 0.2, 0.5}, 0., {0., 0., 1.}, Feature::face);  // on it: the pseudo-normals
  check({0.5, 0.2, 0.5}, 0., {s, 0., s}, Feature::edge);
  check({0.5, 0.5, 0.5}, 0., {t, t, t}, Feature::vertex);
  check({50., 0.1, 0.2}, 49.5, {1., 0., 0.}, Feature::face);  // far beyond the grid
  BOOST_TEST(cube.at({50., 0.1, 0.2}, 1.).distance == HUGE_VAL);
  BOOST_TEST(cube.at({0.1, 0.2, 0.1}, 0.01).distance == -0.3,
             digits(1e-13));  // deep inside is never far away

  cube.velocity = Vector<3>(2., 0., 0.);
  cube.spin = Vector<3>(0., 0., 0.25 * pi);
  BOOST_TEST(cube.velocity_at({0., 0.8, 0.}, cube.at({0., 0.8, 0.}))[0] == 2. - 0.5 * 0.25 * pi,
             digits(1e-13));
  cube.advance(1.);  // an eighth of a turn
  check({2., 0.1, 0.8}, 0.3, {0., 0., 1.}, Feature::face);
  check({2. + 0.5 / s + 0.1, 0., 0.1}, 0.1, {1., 0., 0.}, Feature::edge);
}

// Against all facets one by one, the side from the solid angle that they fill (4 pi inside); near, far and
// inside, with and without a limit.
BOOST_AUTO_TEST_CASE(distances_to_a_horned_body_by_brute_force) {
  const auto body = horned_body(ParticlesAre::outside), cavity = horned_body(ParticlesAre::inside);
  std::size_t inside = 0, edges = 0, vertices = 0;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const Vector<3> x = (k % 10 == 0 ? 6. : 1.6) * random_vector<3>(k);
    double nearest = HUGE_VAL, angle = 0.;
    for (const auto &face : body->mesh().faces) {
      const Vector<3> a = body->node(face[0]), b = body->node(face[1]), c = body->node(face[2]);
      // the plane if its foot lies in the triangle, else the three sides
      const Vector<3> n = (b - a).cross(c - a).normalized(), foot = x - n.dot(x - a) * n;
      bool within = true;
      for (const auto &[p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        within = within && n.dot((q - p).cross(foot - p)) >= 0.;
        const double along = std::clamp((x - p).dot(q - p) / (q - p).squaredNorm(), 0., 1.);
        nearest = std::min(nearest, (x - p - along * (q - p)).norm());
      }
      if (within) nearest = std::min(nearest, std::abs(n.dot(x - a)));
      const Vector<3> u = a - x, v = b - x, w = c - x;
      angle += 2. * std::atan2(u.dot(v.cross(w)), u.norm() * v.norm() * w.norm() + u.dot(v) * w.norm() +
                                                      v.dot(w) * u.norm() + w.dot(u) * v.norm());
    }
    const bool in = angle > 2. * pi;
    const auto c = body->at(x);
    BOOST_TEST(c.distance == (in ? -nearest : nearest), digits(1e-10));
    BOOST_TEST(c.normal.norm() == 1., digits(1e-12));
    inside += in;
    edges += c.feature == TriangulatedBody::Feature::edge;
    vertices += c.feature == TriangulatedBody::Feature::vertex;
    const double limit = 0.2, limited = body->at(x, limit).distance;
    BOOST_TEST((c.distance < limit ? limited == c.distance : limited >= limit));
    BOOST_TEST(cavity->at(x).distance == -c.distance, digits(1e-12));
    BOOST_CHECK_SMALL((cavity->at(x).normal + c.normal).norm(), 1e-12);
  }
  BOOST_TEST(inside > 300u);
  BOOST_TEST(edges > 300u);
  BOOST_TEST(vertices > 100u);
}

BOOST_AUTO_TEST_CASE(a_surface_that_is_none_is_refused) {
  const auto refused = [](TriangleMesh mesh, const std::vector<Vector<3>> &nodes, const std::string &words) {
    BOOST_CHECK_EXCEPTION(TriangulatedBody(mesh, nodes, ParticlesAre::outside), std::invalid_argument,
                          [&](const std::invalid_argument &e) {
                            return std::string(e.what()).find(words) != std::string::npos;
                          });
  };
  TriangleMesh open = cube_mesh(), turned = cube_mesh();
  open.faces.pop_back();
  refused(open, cube_nodes(), "are not closed");
  for (auto &face : turned.faces) std::swap(face[0], face[1]);
  refused(turned, cube_nodes(), "counter-clockwise seen from outside");
  std::vector<Vector<3>> flat = cube_nodes();
  flat[0] = 0.5 * (flat[1] + flat[2]);
  refused(cube_mesh(), flat, "has no area");
  flat.pop_back();
  refused(cube_mesh(), flat, "name 8 nodes, but there are 7");
  BOOST_CHECK_THROW(SphereSurface<2>({0., 0.}, 0., ParticlesAre::inside), std::invalid_argument);
  BOOST_CHECK_THROW(Plane<2>({0., 0.}, {0., 0.}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(forces_are_the_slope_of_the_energy_for_every_shape_and_law) {
  ParticleSystem<2> flat;
  put<2>(flat, cloud<2>(40, 1.5));
  flat.add(std::make_unique<Obstacles<2>>(
      "walls", SurfacePenalty{3e3}, std::make_unique<Plane<2>>(Vector<2>(0.1, -0.5), Vector<2>(1., 2.)),
      std::make_unique<SphereSurface<2>>(Vector<2>(0.2, 0.1), 1.2, ParticlesAre::inside),
      std::make_unique<SphereSurface<2>>(Vector<2>(0.3, -0.2), 0.6, ParticlesAre::outside)));
  BOOST_CHECK_SMALL(test::slope_error(flat, 1e-6, 1), 1e-7);
  ParticleSystem<3> nodes;
  put<3>(nodes, cloud<3>(60, 1.3));
  nodes.add(std::make_unique<Obstacles<3>>(
      "walls", SurfacePenalty{3e3}, horned_body(ParticlesAre::outside),
      std::make_unique<Plane<3>>(Vector<3>(0.1, -0.5, 0.), Vector<3>(1., 2., 3.)),
      std::make_unique<SphereSurface<3>>(Vector<3>(0.2, 0.1, 0.), 1.2, ParticlesAre::inside)));
  BOOST_CHECK_SMALL(test::slope_error(nodes, 1e-6, 1), 1e-6);
  for (const bool locally_stiff : {false, true}) {  // centres that have not passed any surface
    ParticleSystem<3> cells;
    const auto body = horned_body(ParticlesAre::outside);
    std::vector<Vector<3>> places;
    for (const Vector<3> &x : cloud<3>(300, 1.6))
      if (body->at(x).distance > 0.1 && x.norm() < 1.7) places.push_back(x);
    BOOST_TEST(places.size() > 50u);
    put<3>(cells, places);
    make_spheres(cells.particles);
    SphereOnSurface law;
    if (locally_stiff) law.material = {.modulus = 300., .stiffness = LocalStiffness::repaired_C9()};
    cells.add(std::make_unique<Obstacles<3>>(
        "walls", law, horned_body(ParticlesAre::outside),
        std::make_unique<SphereSurface<3>>(Vector<3>(0., 0., 0.), 1.8, ParticlesAre::inside)));
    BOOST_CHECK_SMALL(test::slope_error(cells, 1e-6, 1), 1e-5);
  }
}

// What the particles get the bodies get, with the opposite sign: forces, and moments about the origin.
BOOST_AUTO_TEST_CASE(momentum_and_angular_momentum_are_kept) {
  ParticleSystem<3> system;
  put<3>(system, cloud<3>(400, 1.4), 50);
  const Obstacles<3> &walls = system.add(std::make_unique<Obstacles<3>>(
      "walls", SurfacePenalty{1e3}, horned_body(ParticlesAre::outside),
      std::make_unique<SphereSurface<3>>(Vector<3>(0.3, 0.1, 0.), 1.5, ParticlesAre::inside),
      std::make_unique<Plane<3>>(Vector<3>(0.1, -0.5, 0.), Vector<3>(1., 2., 3.))));
  system.compute_forces();
  Vector<3> force = Vector<3>::Zero(), moment = Vector<3>::Zero();
  double size = 0.;
  for (std::size_t i = 0; i < system.particles.size(); ++i) {
    const Vector<3> f(system.particles.f[0][i], system.particles.f[1][i], system.particles.f[2][i]);
    force += f;
    moment += system.particles.position(i).cross(f);
    size += f.norm();
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    BOOST_TEST(walls[k].pressing() > 0.);
    force += walls[k].force();
    moment += walls[k].moment() + walls[k].centre.cross(walls[k].force());
  }
  BOOST_CHECK_SMALL(force.norm() / size, 1e-14);
  BOOST_CHECK_SMALL(moment.norm() / size, 1e-14);
}

// A particle is pushed from rest by a plate that comes at speed u: elastic bounce off a heavy wall, v = 2 u,
// work = m (2u)^2/2.
BOOST_AUTO_TEST_CASE(work_of_a_driven_plate_is_the_energy_gained) {
  ParticleSystem<2> system;
  put<2>(system, {{0., 0.}});
  Obstacles<2> &plate = system.add(std::make_unique<Obstacles<2>>(
      "plate", SurfacePenalty{400.}, std::make_unique<Plane<2>>(Vector<2>(0., -0.05), Vector<2>(0., 1.))));
  plate[0].velocity[1] = 0.5;
  KickDriftKick<2> integrator(system);
  system.compute_forces();
  // omega = 20 1/s: touch at t = 0.1, half a period of contact after it
  double worst = 0., deepest = 0.;
  for (int s = 0; s < 20000; ++s) {
    integrator.step(2e-5);
    deepest = std::max(deepest, plate.deepest());
    worst = std::max(worst, std::abs(plate.work() - system.potential_energy() - system.kinetic_energy()));
  }
  // at every moment, under load too: of m u^2/2, (omega dt)^2 and the step in which it is touched; a work
  // that lags by half a step would be off by k g u dt/2 = 1e-4
  BOOST_TEST(worst < 1e-6);
  BOOST_TEST(deepest == 0.5 / 20., digits(1e-5));  // u/omega
  BOOST_TEST(plate.deepest() == 0.);
  BOOST_TEST(system.particles.v[1][0] == 1., digits(1e-6));
  BOOST_TEST(plate.work() == system.potential_energy() + system.kinetic_energy(), digits(1e-6));
}

// A travelling and spinning body in a shrinking sphere, particles between them, with a drag of the medium:
// work = energy gained + heat, of second order in the step.
BOOST_AUTO_TEST_CASE(work_of_moving_bodies_is_the_energy_gained_and_the_heat) {
  const auto missing = [](const double dt, double &work) {
    ParticleSystem<3> system;
    std::vector<Vector<3>> places;
    const auto body = horned_body(ParticlesAre::outside);
    for (const Vector<3> &x : cloud<3>(200, 2.))
      if (body->at(x).distance > 0. && x.norm() < 2.) places.push_back(x);
    put<3>(system, places, 20);
    Obstacles<3> &walls = system.add(std::make_unique<Obstacles<3>>(
        "walls", SurfacePenalty{400.}, horned_body(ParticlesAre::outside),
        std::make_unique<SphereSurface<3>>(Vector<3>(0., 0., 0.), 2., ParticlesAre::inside)));
    walls[0].velocity = Vector<3>(0.2, 0.1, 0.);
    walls[0].spin = Vector<3>(0.3, 0.2, 1.);
    walls[1].growth = 0.3;
    KickDriftKick<3> integrator(system);
    system.compute_forces();
    double heat = 0.;
    const double damping = 0.4;
    for (int s = 0; s < int(std::lround(1. / dt)); ++s) {
      integrator.step(dt, damping);
      heat += system.kinetic_energy() *
              std::expm1(2. * damping * dt);  // what the drag has taken at the end of the step
    }
    work = walls.work();
    return work - system.potential_energy() - system.kinetic_energy() - heat;
  };
  double work = 0.;
  const double coarse = missing(2e-3, work), fine = missing(5e-4, work);
  BOOST_TEST(work > 1.);
  BOOST_CHECK_SMALL(coarse / work, 2e-3);
  BOOST_CHECK_SMALL(fine / work, 2e-4);
}

// A plate of 1 kg pressed by 2 N on a clamped particle (k = 100 N/m) swings about the depth 0.02 m with
// period 2 pi/10 s.
BOOST_AUTO_TEST_CASE(a_loaded_plate_swings) {
  ParticleSystem<2> system;
  put<2>(system, {{0., 0.}});
  system.particles.inverse_mass[0] = 0.;
  Obstacles<2> &plates = system.add(std::make_unique<Obstacles<2>>(
      "plate", SurfacePenalty{100.}, std::make_unique<Plane<2>>(Vector<2>(0., 0.), Vector<2>(0., -1.))));
  plates[0].mass = 1.;
  plates[0].load[1] = -2.;
  KickDriftKick<2> integrator(system);
  system.compute_forces();
  const double period = 2. * pi / 10.;
  const int steps = 2000;
  double lowest = 0.;
  for (int s = 0; s < steps; ++s) {
    integrator.step(period / steps);
    lowest = std::min(lowest, plates[0].centre[1]);
  }
  // Leapfrog started with v(0) instead of v(-dt/2): off by omega dt/2 = 1.6e-3 of the amplitude.
  BOOST_CHECK_SMALL(lowest + 0.04, 0.04 * 2e-3);
  BOOST_CHECK_SMALL(plates[0].centre[1], 0.02 * 7e-3);
}

namespace {
/// A floor that comes, and a lid with mass on two particles.
Obstacles<2> &floor_and_lid(ParticleSystem<2> &system, const double low, const double stiffness) {
  put<2>(system, {{0., 0.}, {0.1, 0.01}});
  Obstacles<2> &two = two_plates<2>(system, stiffness, low, 0.02);
  two[0].velocity[1] = 0.5;
  two[1].mass = 2.;
  two[1].load[1] = -1.;
  return two;
}
}  // namespace

// Obstacles are stepped with the fast terms: where there are no others, r-RESPA is kick-drift-kick with the
// substep.
BOOST_AUTO_TEST_CASE(under_respa_plates_take_the_substep) {
  const unsigned int substeps = 5;
  const double h = 1e-3;
  ParticleSystem<2> plain, split;
  const Obstacles<2> &a = floor_and_lid(plain, -0.05, 400.), &b = floor_and_lid(split, -0.05, 400.);
  KickDriftKick<2> small_steps(plain);
  Respa<2> large_steps(split, substeps);
  plain.compute_forces();
  large_steps.compute_forces();
  double most[2] = {0., 0.};
  for (int s = 0; s < 200; ++s) {
    for (unsigned int k = 0; k < substeps; ++k) small_steps.step(h);
    large_steps.step(substeps * h);
    // sums in another order: round-off
    BOOST_CHECK_SMALL(plain.particles.x[1][0] - split.particles.x[1][0], 1e-11);
    BOOST_CHECK_SMALL(plain.particles.v[1][1] - split.particles.v[1][1], 1e-9);
    BOOST_CHECK_SMALL(a[1].centre[1] - b[1].centre[1], 1e-11);
    BOOST_CHECK_SMALL(a.work() - b.work(), 1e-9);
    for (const std::size_t k : {0, 1}) {
      BOOST_CHECK_SMALL(a[k].pressing() - b[k].pressing(), 1e-8);
      most[k] = std::max(most[k], a[k].pressing());
    }
  }
  BOOST_TEST(most[0] > 1.);  // both have pushed
  BOOST_TEST(most[1] > 1.);
}

BOOST_AUTO_TEST_CASE(a_saved_plate_goes_on_with_the_same_bits) {
  ParticleSystem<2> whole, second;
  const Obstacles<2> &a = floor_and_lid(whole, -0.001, 100.), &b = floor_and_lid(second, -0.001, 100.);
  KickDriftKick<2> step_whole(whole), step_second(second);
  whole.compute_forces();
  for (int s = 0; s < 50; ++s) step_whole.step(1e-3);
  const std::string bytes = archived(whole);
  for (int s = 0; s < 50; ++s) step_whole.step(1e-3);
  restore(bytes, second);
  for (int s = 0; s < 50; ++s) step_second.step(1e-3);
  for (int d = 0; d < 2; ++d) BOOST_CHECK(whole.particles.x[d] == second.particles.x[d]);
  for (std::size_t k = 0; k < 2; ++k)
    BOOST_CHECK(a[k].centre == b[k].centre && a[k].pressing() == b[k].pressing());
  BOOST_CHECK(a.work() == b.work());
}

// A body with mass among many groups, turning: the same bits on one, two and three threads, and after a
// checkpoint.
BOOST_AUTO_TEST_CASE(a_body_among_groups_has_the_same_bits_always) {
  struct Outcome {
    Particles<3>::Components x;
    Vector<3> centre, force;
    double work = 0.;
  };
  const auto go = [](const unsigned int threads, const int stop_at) {
    const auto make = [threads](ParticleSystem<3> &system) -> Obstacles<3> & {
      put<3>(system, cloud<3>(600, 1.6), 7);
      system.threads = threads;
      Obstacles<3> &walls = system.add(
          std::make_unique<Obstacles<3>>("walls", SurfacePenalty{200.}, horned_body(ParticlesAre::outside)));
      walls[0].mass = 50.;
      walls[0].load = Vector<3>(3., 0., 0.);
      walls[0].spin = Vector<3>(0., 0.3, 1.);
      return walls;
    };
    ParticleSystem<3> first, second;
    Obstacles<3> *walls = &make(first);
    ParticleSystem<3> *system = &first;
    std::unique_ptr<KickDriftKick<3>> integrator = std::make_unique<KickDriftKick<3>>(first);
    first.compute_forces();
    for (int s = 0; s < 40; ++s) {
      if (s == stop_at) {
        walls = &make(second);
        restore(archived(first), second);
        system = &second;
        integrator = std::make_unique<KickDriftKick<3>>(second);
      }
      integrator->step(2e-3);
    }
    return Outcome{system->particles.x, (*walls)[0].centre, (*walls)[0].force(), walls->work()};
  };
  const Outcome one = go(1, -1);
  BOOST_TEST(one.force.norm() > 0.);
  for (const auto &[threads, stop_at] : {std::pair(2u, -1), std::pair(3u, -1), std::pair(1u, 20)}) {
    const Outcome other = go(threads, stop_at);
    BOOST_CHECK(other.x == one.x);
    BOOST_CHECK(other.centre == one.centre && other.force == one.force);
    BOOST_CHECK(other.work == one.work);
  }
}

// Who touches is asked, at any time: not only after the forces, and without changing anything.
BOOST_AUTO_TEST_CASE(who_touches_is_asked) {
  ParticleSystem<3> system;
  put<3>(system, {{0., 0., 0.2}, {0., 0., 0.9}, {0., 0., 0.1}});
  make_spheres(system.particles);
  const Obstacles<3> &floor = system.add(std::make_unique<Obstacles<3>>(
      "floor", SphereOnSurface{{.friction = 5.}},
      std::make_unique<Plane<3>>(Vector<3>(0., 0., 0.), Vector<3>(0., 0., 1.))));
  std::vector<std::size_t> found;
  floor.for_touches(system.particles, [&](const auto &touch) {
    found.push_back(touch.particle);
    BOOST_TEST(touch.contact.distance == system.particles.x[2][touch.particle], digits(1e-14));
    BOOST_TEST(touch.does.force > 0.);
  });
  BOOST_TEST((found == std::vector<std::size_t>{0, 2}));
  BOOST_TEST(floor[0].pressing() == 0.);  // nobody has pushed
  BOOST_TEST(floor.friction() == 5.);
}

BOOST_AUTO_TEST_SUITE_END()
