// Rigid bodies of triangles that are moved by what touches them, with inertia and without; how round they
// are.
#include "micro/engine/kick_drift_kick.h"
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/geometry/facet_curvature.h"
#include "micro/geometry/geodesic_sphere.h"
#include "micro/geometry/solid_inertia.h"
#include "micro/geometry/triangulated_body.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/obstacles.h"
#include "micro/terms/sphere_contacts.h"
#include "tests/micro/slope_of_energy.h"

#include <boost/test/unit_test.hpp>

#include <numbers>

using namespace turgor;

namespace {
const auto digits = [](const double relative) { return boost::test_tools::tolerance(relative); };

/// A box of these sides about a place; node bits: x, y, z.
std::unique_ptr<TriangulatedBody> box(const Vector<3> &sides, const Vector<3> &middle = Vector<3>::Zero()) {
  TriangleMesh mesh;
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  std::vector<Vector<3>> nodes;
  for (int k = 0; k < 8; ++k)
    nodes.push_back(middle +
                    sides.cwiseProduct(Vector<3>((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5)));
  return std::make_unique<TriangulatedBody>(mesh, nodes, ParticlesAre::outside);
}

Tensor2<3> orientation(const TriangulatedBody &b) {
  Tensor2<3> R;
  for (int d = 0; d < 3; ++d) R.col(d) = (b.node(std::size_t(1) << d) - b.node(0)).normalized();
  return R;
}

const Vector<3> sides(1., 2., 3.), inertia = Vector<3>(13., 10., 5.) * 6. / 12.;  // density 1: mass 6
const Vector<3> start_spin(0.05, 1.5, 0.1);  // about the middle axis: it tumbles

/// Orientation after a time by Runge-Kutta's method of fourth order on dR/dt = R [J^-1 R^T L]_x, another way.
Tensor2<3> by_runge_kutta(const double time, const int steps) {
  Tensor2<3> R = Tensor2<3>::Identity();
  const Vector<3> L = inertia.cwiseProduct(start_spin);
  const auto rate = [&](const Tensor2<3> &at) {
    const Vector<3> w = at * Vector<3>((at.transpose() * L).cwiseQuotient(inertia));
    Tensor2<3> result;
    for (int d = 0; d < 3; ++d) result.col(d) = w.cross(at.col(d));
    return result;
  };
  const double h = time / steps;
  for (int k = 0; k < steps; ++k) {
    const Tensor2<3> a = rate(R), b = rate(R + 0.5 * h * a), c = rate(R + 0.5 * h * b), d = rate(R + h * c);
    R += h / 6. * (a + 2. * b + 2. * c + d);
  }
  return R;
}

GeodesicSphere horned(const unsigned int nu) {
  GeodesicSphere ball = make_geodesic_sphere(nu);
  for (Vector<3> &x : ball.positions)
    x *= 1. + 0.2 * std::sin(3. * std::atan2(x[1], x[0])) * (1. - x[2] * x[2]) + 0.1 * x[2];
  return ball;
}

Vector<3> random_place(const std::uint64_t i) {
  return 2. *
             Vector<3>(random_uniform(9, 3 * i), random_uniform(9, 3 * i + 1), random_uniform(9, 3 * i + 2)) -
         Vector<3>::Ones();
}
}  // namespace

BOOST_AUTO_TEST_SUITE(free_body)

BOOST_AUTO_TEST_CASE(inertia_of_a_box_and_of_a_ball) {
  const auto body = box(sides, {7., -2., 1.});
  body->spin = {1., 0., 0.};
  body->set_free(1.);
  BOOST_TEST(body->mass == 6., digits(1e-13));
  BOOST_CHECK_SMALL((body->centre - Vector<3>(7., -2., 1.)).norm(), 1e-13);
  BOOST_CHECK_SMALL((body->angular_momentum() - Vector<3>(6.5, 0., 0.)).norm(), 1e-12);
  BOOST_TEST(body->kinetic_energy() == 3.25, digits(1e-12));
  const GeodesicSphere ball = make_geodesic_sphere(16);
  const SolidInertia solid = solid_inertia(ball.mesh, ball.positions);
  BOOST_TEST(solid.volume == 4. / 3. * std::numbers::pi, digits(0.01));
  BOOST_CHECK_SMALL((solid.inertia(1.) - 0.4 * solid.volume * Tensor2<3>::Identity()).norm() / solid.volume,
                    0.01);
  BOOST_CHECK_THROW(body->set_free(0.), std::invalid_argument);
}

// Euler's top: L is kept to the last bits, energy to second order without drift, the way of second order.
BOOST_AUTO_TEST_CASE(a_free_top) {
  struct Outcome {
    double energy, momentum, way;
  };
  const double time = 20.;
  const Tensor2<3> exact = by_runge_kutta(time, 40000);
  const auto spun = [&](const int steps) {
    const auto body = box(sides);
    body->spin = start_spin;
    body->set_free(1.);
    const Vector<3> L = body->angular_momentum();
    Outcome outcome{};
    double least = HUGE_VAL;
    for (int k = 0; k < steps; ++k) {
      body->advance(time / steps);
      const Tensor2<3> R = orientation(*body);
      const Vector<3> own = R.transpose() * L;
      const double energy = 0.5 * own.dot(own.cwiseQuotient(inertia)),
                   started = 0.5 * start_spin.dot(inertia.cwiseProduct(start_spin));
      outcome.energy = std::max(outcome.energy, std::abs(energy / started - 1.));
      outcome.momentum = std::max(outcome.momentum, (body->angular_momentum() - L).norm() / L.norm());
      BOOST_REQUIRE_SMALL((R.transpose() * R - Tensor2<3>::Identity()).norm(), 1e-12);
      least = std::min(least, R.col(1)[1]);
    }
    BOOST_TEST(least < -0.9);  // it has tumbled
    outcome.way = (orientation(*body) - exact).norm();
    return outcome;
  };
  const Outcome coarse = spun(2000), fine = spun(4000);
  BOOST_TEST_MESSAGE("energy " << coarse.energy << ' ' << fine.energy << ", way " << coarse.way << ' '
                               << fine.way << ", angular momentum " << fine.momentum);
  BOOST_TEST(coarse.momentum < 1e-12);
  BOOST_TEST(coarse.energy < 1e-3);
  BOOST_TEST(coarse.energy / fine.energy == 4., digits(0.05));
  BOOST_TEST(coarse.way / fine.way == 4., digits(0.05));
}

// Spheres fly against a box that is free: momentum and angular momentum of all to round-off (both with
// velocities of half a step before), energy to second order. (Outside of what is convex the distance has a
// smooth slope; nodes that a penalty lets inside jump from face to face at its edges, and lose the order
// there.)
BOOST_AUTO_TEST_CASE(momentum_and_energy_of_a_body_in_a_crowd) {
  struct Sums {
    Vector<3> momentum = Vector<3>::Zero(), angular = Vector<3>::Zero();
  };
  const auto lost = [](const double dt) {
    ParticleSystem<3> system;
    Particles<3> &p = system.particles;
    auto shape = box({1., 1.4, 2.});
    std::vector<Vector<3>> places;
    for (std::uint64_t k = 0; k < 400; ++k)
      if (const Vector<3> x = 2.5 * random_place(k); shape->at(x).distance > 0.31) places.push_back(x);
    const std::uint32_t n = std::uint32_t(places.size());
    p.resize(n);
    for (std::uint32_t i = 0; i < n; i += 20) p.groups.push_back({i, i, std::min(n, i + 20)});
    for (std::uint32_t i = 0; i < n; ++i) {
      p.inverse_mass[i] = 10.;
      for (int d = 0; d < 3; ++d) {
        p.x[d][i] = places[i][d];
        p.v[d][i] = -0.6 * places[i][d] + 0.3 * random_place(1000 + i)[d];
      }
    }
    p.declare("radius");
    p.declare("modulus");
    p.field("radius").assign(n, 0.3);
    p.field("modulus").assign(n, 300.);
    TriangulatedBody &body = *shape;
    system.add(std::make_unique<Obstacles<3>>("body", SphereOnSurface{}, std::move(shape)));
    body.spin = {0.3, 0.2, 0.5};
    body.velocity = {0.1, 0., 0.};
    body.set_free(1.);
    KickDriftKick<3> stepper(system);
    system.compute_forces();
    const auto sums = [&] {  // half a step back
      Sums s;
      for (std::uint32_t i = 0; i < n; ++i) {
        Vector<3> v;
        for (int d = 0; d < 3; ++d) v[d] = p.v[d][i] - 0.5 * dt * p.f[d][i] * p.inverse_mass[i];
        s.momentum += v / p.inverse_mass[i];
        s.angular += p.position(i).cross(v) / p.inverse_mass[i];
      }
      s.momentum += body.mass * body.velocity;
      s.angular += body.angular_momentum() + body.mass * body.centre.cross(body.velocity);
      return s;
    };
    stepper.step(dt);
    const Sums start = sums();
    double energy_0 = 0., worst = 0., before = body.kinetic_energy(), others = 0., size = 0.;
    const Vector<3> L_0 = body.angular_momentum();
    for (int k = 0; k < int(std::lround(1.5 / dt)); ++k) {
      others = system.kinetic_energy() + system.potential_energy();
      stepper.step(dt);
      const double energy = others + 0.5 * (before + body.kinetic_energy());
      before = body.kinetic_energy();
      if (k == 0) energy_0 = energy;
      worst = std::max(worst, std::abs(energy / energy_0 - 1.));
      size = std::max(size, (body.angular_momentum() - L_0).norm());
    }
    const Sums end = sums();
    BOOST_TEST(size > 0.05);  // it has been turned
    BOOST_CHECK_SMALL((end.momentum - start.momentum).norm(), 1e-11);
    BOOST_CHECK_SMALL((end.angular - start.angular).norm(), 1e-11);
    return worst;
  };
  const double coarse = lost(2e-3), fine = lost(1e-3);
  BOOST_TEST_MESSAGE("energy " << coarse << ' ' << fine);
  BOOST_TEST(coarse < 1e-3);
  BOOST_TEST(coarse / fine > 3.);
}

// Without inertia: a body that is pulled pushes two cells before it, and drags one that it slides along, by
// hand.
BOOST_AUTO_TEST_CASE(a_body_with_drag_moves_by_its_load) {
  constexpr double R = 0.35, medium = 5., own = 2.;
  const auto make = [](ParticleSystem<3> &system, SystemMotion<3> &motion, const double between,
                       const double with_body) -> Obstacles<3> & {
    Particles<3> &p = system.particles;
    p.resize(2);
    p.groups = {{0, 0, 1}, {1, 1, 2}};
    SphereContacts &contacts = system.add(std::make_unique<SphereContacts>(HertzContact(), 0.1));
    contacts.friction = {.normal = between, .tangential = between};
    Obstacles<3> &bodies = system.add(
        std::make_unique<Obstacles<3>>("body", SphereOnSurface{{.friction = with_body}}, box({1., 1., 1.})));
    bodies.listed_in(contacts.contact_list());
    p.field("radius") = {R, R};
    p.field("modulus") = {100., 100.};
    p.x[0] = {0.5 + 0.9 * R, 0.5 + 2.8 * R};
    p.x[1] = p.x[2] = {0., 0.};
    motion.medium = {medium, medium};
    bodies[0].drag = own;
    return bodies;
  };
  {
    ParticleSystem<3> system;
    SystemMotion<3> motion(system, {.tolerance = 1e-12});
    Obstacles<3> &bodies = make(system, motion, 3., 4.);
    bodies[0].load = {1.2, 0., 0.};
    bodies[0].turning_drag = 1.;
    Overdamped<3> stepper({.method = OverdampedMethod::implicit, .tolerance = 1e-3, .first_step = 1e-3},
                          motion, 1);
    for (double t = 0.; t < 20.;) {
      const double h = stepper.step(system.particles, 0.01);
      system.advance(h);
      t += h;
    }
    BOOST_TEST(bodies[0].velocity[0] == 1.2 / (own + 2. * medium), digits(1e-3));
    BOOST_TEST(system.particles.v[0][1] == 1.2 / (own + 2. * medium), digits(1e-3));
  }
  // One solution is exact, however much rubs: the matrix has the body's velocities among its unknowns.
  for (const double friction : {40., 4e3, 4e5, 4e7}) {
    ParticleSystem<3> system;
    SystemMotion<3> motion(system, {.tolerance = 1e-9});
    Obstacles<3> &bodies = make(system, motion, 30., friction);
    Obstacle<3> &body = bodies[0];
    body.load = {0., 1.2, 0.};
    motion.forces(system.particles, false);
    motion.velocities(system.particles, 0.);
    double rubs = 0.;
    bodies.for_touches(system.particles, [&](const auto &touch) { rubs += friction * touch.does.area; });
    const auto &v = system.particles.v[1];
    BOOST_TEST(own * body.velocity[1] + rubs * (body.velocity[1] - v[0]) == 1.2, digits(1e-7));
    BOOST_TEST(own * body.velocity[1] + medium * (v[0] + v[1]) == 1.2, digits(1e-8));  // borne by the medium
    const double stuck =
        1.2 / (own + 2. * medium);  // no friction between the cells would let the second rest
    BOOST_TEST(body.velocity[1] > stuck);
    // free to turn as well: the moment of the cell beside it spins it
    body.turning_drag = 3.;
    motion.forces(system.particles, false);
    motion.velocities(system.particles, 0.);
    BOOST_TEST(body.turning_drag * body.spin[2] ==
                   -0.5 * rubs * (body.velocity[1] + 0.5 * body.spin[2] - system.particles.v[1][0]),
               digits(1e-7));
    BOOST_TEST(own * body.velocity[1] + medium * (v[0] + v[1]) == 1.2, digits(1e-8));
    BOOST_TEST(body.spin[2] < 0.);
  }
}

// Steps see the body: its error and its way are measured with the cells'. Of a body much lighter in the
// medium than its contacts are stiff, explicit steps stay stable and implicit ones are long.
BOOST_AUTO_TEST_CASE(steps_follow_a_body_with_little_drag) {
  constexpr double medium = 5., own = 0.02, R = 0.35;
  const auto run = [&](const OverdampedMethod method, const double tolerance) {
    ParticleSystem<3> system;
    SystemMotion<3> motion(system, {.tolerance = 1e-10});
    Particles<3> &p = system.particles;
    p.resize(1);
    p.groups = {{0, 0, 1}};
    SphereContacts &contacts = system.add(std::make_unique<SphereContacts>(HertzContact(), 0.1));
    Obstacles<3> &bodies = system.add(
        std::make_unique<Obstacles<3>>("body", SphereOnSurface{{.friction = 4.}}, box({1., 1., 1.})));
    bodies.listed_in(contacts.contact_list());
    p.field("radius") = {R};
    p.field("modulus") = {100.};
    p.x[0] = {0.5 + 0.97 * R};
    p.x[1] = {0.};
    p.x[2] = {0.};
    motion.medium = {medium};
    bodies[0].drag = own;
    bodies[0].load = {1.2, 0., 0.};
    Overdamped<3> stepper({.method = method, .tolerance = tolerance, .first_step = 1e-5}, motion, 1);
    double fastest = 0., slowest = HUGE_VAL;
    std::size_t steps = 0;
    for (double t = 0.; t < 1.; ++steps) {
      const double h = stepper.step(p, 1. - t);
      system.advance(h);
      t += h;
      if (t > 0.1) {  // the body has come to lean on the cell
        fastest = std::max(fastest, bodies[0].velocity[0]);
        slowest = std::min(slowest, bodies[0].velocity[0]);
      }
    }
    struct Outcome {
      double x, fastest, slowest;
      std::size_t steps;
    };
    return Outcome{bodies[0].centre[0], fastest, slowest, steps};
  };
  const auto exact = run(OverdampedMethod::heun, 1e-6);
  BOOST_TEST(exact.slowest > 0.);
  for (const auto method : {OverdampedMethod::euler, OverdampedMethod::heun, OverdampedMethod::implicit}) {
    const auto coarse = run(method, 1e-3), fine = run(method, 1e-4);
    BOOST_TEST_MESSAGE(int(method) << ": " << coarse.x << " in " << coarse.steps << ", " << fine.x << " in "
                                   << fine.steps << " of " << exact.x << " in " << exact.steps << "; "
                                   << coarse.slowest << " .. " << coarse.fastest);
    BOOST_TEST(coarse.x == exact.x, digits(5e-3));
    BOOST_TEST(fine.x == exact.x, digits(5e-4));
    BOOST_TEST(coarse.slowest > 0.);
    BOOST_TEST(coarse.fastest < 2. * exact.fastest);
  }
  BOOST_TEST(run(OverdampedMethod::implicit, 1e-3).steps < run(OverdampedMethod::heun, 1e-3).steps);
}

// A ball of facets is as round as the ball: curvature, and the force on a sphere at its side, to second order
// in the width of the facets. Flat sides stay flat.
BOOST_AUTO_TEST_CASE(a_ball_of_facets_is_round) {
  struct Off {
    double curvature = 0., force = 0.;
  };
  const auto off = [](const unsigned int nu, const ParticlesAre side) {
    const GeodesicSphere ball = make_geodesic_sphere(nu);
    const TriangulatedBody body(ball.mesh, ball.positions, side);
    const SphereSurface<3> exact(Vector<3>::Zero(), 1., side);
    const double r = side == ParticlesAre::outside ? 1.3 : 0.7;
    Off worst;
    for (std::uint64_t k = 0; k < 500; ++k) {
      const Vector<3> x = r * random_place(k).normalized();
      const auto a = body.at(x), b = exact.at(x);
      const WallMaterial law;
      worst.curvature = std::max(worst.curvature, std::abs(a.curvature / b.curvature - 1.));
      // where they overlap alike: the law alone
      worst.force = std::max(worst.force, std::abs(law(0.4, 0.4, 100., a.curvature, b.distance).force /
                                                       law(0.4, 0.4, 100., b.curvature, b.distance).force -
                                                   1.));
    }
    return worst;
  };
  for (const auto side : {ParticlesAre::outside, ParticlesAre::inside}) {
    const Off coarse = off(4, side), middle = off(8, side), fine = off(16, side);
    BOOST_TEST_MESSAGE("curvature " << coarse.curvature << ' ' << middle.curvature << ' ' << fine.curvature
                                    << ", force " << coarse.force << ' ' << middle.force << ' '
                                    << fine.force);
    BOOST_TEST(fine.curvature < 0.01);
    BOOST_TEST(coarse.curvature / middle.curvature > 3.5);
    BOOST_TEST(middle.curvature / fine.curvature > 3.5);
    BOOST_TEST(middle.force / fine.force > 3.5);
  }
  for (std::uint64_t k = 0; k < 500; ++k) {
    const auto contact = box({1., 2., 3.})->at(2. * random_place(k));
    BOOST_TEST(contact.curvature == 0.);
    BOOST_TEST(contact.bend.norm() == 0.);
  }
}

// Where the curvature changes along the surface it pushes along it: F = -dE/dx, and the body gets all of it
// back.
BOOST_AUTO_TEST_CASE(uneven_roundness_pushes_along_the_surface) {
  const GeodesicSphere ball = horned(16);
  ParticleSystem<3> system;
  Particles<3> &p = system.particles;
  auto shape = std::make_unique<TriangulatedBody>(ball.mesh, ball.positions, ParticlesAre::outside);
  std::vector<Vector<3>> places;
  std::size_t uneven = 0;
  for (std::uint64_t k = 0; k < 600; ++k)
    if (const Vector<3> x = 1.5 * random_place(k);
        shape->at(x).distance > 0.02 && shape->at(x).distance < 0.3) {
      places.push_back(x);
      uneven += shape->at(x).bend.norm() > 0.01;
    }
  BOOST_TEST(places.size() > 50u);
  BOOST_TEST(uneven > 40u);
  p.resize(places.size());
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    p.groups.push_back({i, i, i + 1});
    p.inverse_mass[i] = 1.;
    for (int d = 0; d < 3; ++d) p.x[d][i] = places[i][d];
  }
  p.declare("radius");
  p.declare("modulus");
  p.field("radius").assign(p.size(), 0.35);
  p.field("modulus").assign(p.size(), 100.);
  const Obstacles<3> &bodies =
      system.add(std::make_unique<Obstacles<3>>("body", SphereOnSurface{}, std::move(shape)));
  BOOST_CHECK_SMALL(test::slope_error(system, 1e-6, 1), 1e-7);
  Vector<3> force = bodies[0].force(),
            moment = bodies[0].moment() + bodies[0].centre.cross(bodies[0].force());
  double size = 0.;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector<3> f(p.f[0][i], p.f[1][i], p.f[2][i]);
    force += f;
    moment += p.position(i).cross(f);
    size += f.norm();
  }
  BOOST_CHECK_SMALL(force.norm() / size, 1e-14);
  BOOST_CHECK_SMALL(moment.norm() / size, 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
