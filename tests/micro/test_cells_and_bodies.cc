// Two kinds of bodies in one scene: centre-based cells and a triangulated rigid body that moves, in one
// system of particles, found by one list of contacts, stepped by the one over-damped stepper, their
// velocities by the one matrix of motion.
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/geometry/geodesic_sphere.h"
#include "micro/geometry/triangulated_body.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/obstacles.h"
#include "micro/terms/sphere_contacts.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

using namespace turgor;

namespace {
constexpr double R = 0.35, medium = 5., speed = 0.1, skin = 0.1;
const auto digits = [](const double relative) { return boost::test_tools::tolerance(relative); };

/// A cube |x| < 1/2 and two cells in a row before its face x = 1/2, all of them touching.
struct Row {
  ParticleSystem<3> system;
  Particles<3> &p = system.particles;
  SphereContacts *contacts;
  Obstacles<3> *bodies;
  SystemMotion<3> motion{system, {.tolerance = 1e-12}};

  Row(const double between_cells, const double with_body) {
    TriangleMesh mesh;
    mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    std::vector<Vector<3>> nodes;  // bits of the number: x, y, z
    for (int k = 0; k < 8; ++k) nodes.emplace_back((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5);
    p.resize(2);
    p.groups = {{0, 0, 1}, {1, 1, 2}};
    contacts = &system.add(std::make_unique<SphereContacts>(HertzContact(), skin));
    contacts->friction = {.normal = between_cells, .tangential = between_cells};
    bodies = &system.add(std::make_unique<Obstacles<3>>(
        "body", SphereOnSurface{{.friction = with_body}},
        std::make_unique<TriangulatedBody>(mesh, nodes, ParticlesAre::outside)));
    bodies->listed_in(contacts->contact_list());
    p.field("radius") = {R, R};
    p.field("modulus") = {100., 100.};
    p.x[0] = {0.5 + 0.9 * R, 0.5 + 2.8 * R};
    p.x[1] = {0.1, 0.1};
    p.x[2] = {0.05, 0.05};
    motion.medium = {medium, medium};
  }

  /// The body moves along the row for so long that nothing changes any more, in steps of at most `longest`
  /// (s). Returns it.
  const Obstacle<3> &push(const OverdampedMethod method, const double longest) {
    Obstacle<3> &body = (*bodies)[0];
    body.velocity = Vector<3>(speed, 0., 0.);
    Overdamped<3> stepper({.method = method, .tolerance = 1e-3, .first_step = 1e-3}, motion, 1);
    for (double t = 0.; t < 20.;) {
      const double h = stepper.step(p, longest);
      system.advance(h);
      t += h;
    }
    system.compute_forces();
    return body;
  }
};
}  // namespace

BOOST_TEST_DONT_PRINT_LOG_VALUE(turgor::OverdampedMethod)

BOOST_AUTO_TEST_SUITE(cells_and_bodies)

// Pushed along, both cells come to move as fast as the body does: it bears the drag of two, and the first
// hands on that of one.
BOOST_DATA_TEST_CASE(a_body_pushes_a_row_of_cells,
                     boost::unit_test::data::make({OverdampedMethod::euler, OverdampedMethod::implicit}),
                     method) {
  Row row(3., 4.);
  const Obstacle<3> &body = row.push(method, 0.02);
  for (const std::size_t i : {0, 1}) BOOST_TEST(row.p.v[0][i] == speed, digits(1e-4));
  BOOST_TEST(body.pressing() == 2. * medium * speed, digits(1e-3));
  BOOST_TEST(row.contacts->contacts()[0].force == medium * speed, digits(1e-3));
  BOOST_CHECK_SMALL(body.force()[0] + row.p.f[0][0] + row.p.f[0][1],
                    1e-12);  // what it pushes with pushes back
}

// Bodies move between steps: the second stage of heun sees them where they were, which makes it of first
// order in their motion.
BOOST_AUTO_TEST_CASE(heun_sees_a_moving_body_to_first_order) {
  const auto error = [](const double longest) {
    Row row(3., 4.);
    return row.push(OverdampedMethod::heun, longest).pressing() / (2. * medium * speed) - 1.;
  };
  const double coarse = error(0.02), fine = error(0.01);
  BOOST_CHECK_SMALL(fine, 0.02);
  BOOST_TEST(coarse / fine == 2., digits(0.1));
}

// A body that slides along the row drags the first cell by friction, and that the second: two equations by
// hand.
BOOST_AUTO_TEST_CASE(a_body_that_slides_by_drags_the_cells) {
  Row row(30., 40.);
  (*row.bodies)[0].velocity = Vector<3>(0., speed, 0.);
  row.motion.forces(row.p, false);
  row.motion.velocities(row.p, 0.);
  double with_body = 0.;
  row.bodies->for_touches(row.p, [&](const auto &touch) { with_body += 40. * touch.does.area; });
  const double between = 30. * row.contacts->contacts()[0].area;
  BOOST_TEST(with_body > 0.);
  BOOST_TEST(between > 0.);
  const double first =
      with_body * speed / (medium + with_body + between - between * between / (medium + between));
  BOOST_TEST(row.p.v[1][0] == first, digits(1e-9));
  BOOST_TEST(row.p.v[1][1] == between * first / (medium + between), digits(1e-9));
}

// The cell that touches the body and the pair that touches are found in the same list, at the same time.
BOOST_AUTO_TEST_CASE(one_list_has_pairs_and_who_is_next_to_a_body) {
  Row row(3., 4.);
  const ContactList<3> &list = *row.contacts->contact_list();
  row.system.compute_forces();
  BOOST_TEST(list.pairs().pairs().size() == 1u);
  BOOST_TEST((list.next_to(0) == std::vector<std::uint32_t>{0}));
  BOOST_TEST(list.covers(row.p));
  const std::size_t builds = list.pairs().builds();

  // A body that comes nearer by less than half a skin finds the same list good, one that has come farther
  // does not. Both kinds are found anew.
  (*row.bodies)[0].velocity = Vector<3>(1., 0., 0.);
  row.system.advance(0.45 * skin);
  BOOST_TEST(list.covers(row.p));
  row.system.advance(0.1 * skin);
  BOOST_TEST(!list.covers(row.p));
  row.p.x[0][1] += 0.3;  // away from the first
  row.system.compute_forces();
  BOOST_TEST(list.pairs().builds() == builds + 1);
  BOOST_TEST(list.pairs().pairs().empty());
  BOOST_TEST((list.next_to(0) == std::vector<std::uint32_t>{0}));

  // one that turns: by the way of the farthest cell
  (*row.bodies)[0].velocity = Vector<3>::Zero();
  (*row.bodies)[0].spin = Vector<3>(0., 0., 1.);
  row.system.advance(0.05 * skin);
  BOOST_TEST(list.covers(row.p));
  row.system.advance(0.5 * skin);
  BOOST_TEST(!list.covers(row.p));
}

// A body of horns turns and travels through a crowd of cells: the same bits as when every cell is asked, on
// any number of threads.
BOOST_AUTO_TEST_CASE(a_listed_body_has_the_same_bits) {
  struct Outcome {
    Particles<3>::Components x;
    Vector<3> force;
    std::size_t looked_at = 0, cells = 0;
  };
  const auto go = [](const bool listed, const unsigned int threads) {
    GeodesicSphere ball = make_geodesic_sphere(4);
    for (Vector<3> &x : ball.positions)
      x *= 1. + 0.35 * std::sin(5. * std::atan2(x[1], x[0])) * (1. - x[2] * x[2]);
    auto shape = std::make_unique<TriangulatedBody>(ball.mesh, ball.positions, ParticlesAre::outside);
    ParticleSystem<3> system;
    system.threads = threads;
    Particles<3> &p = system.particles;
    std::vector<Vector<3>> places;
    for (std::uint64_t i = 0; i < 1500; ++i) {
      const Vector<3> x(random_uniform(3, 3 * i), random_uniform(3, 3 * i + 1), random_uniform(3, 3 * i + 2));
      if (const Vector<3> y = 8. * x - Vector<3>::Constant(4.); shape->at(y).distance > 0.15)
        places.push_back(y);
    }
    p.resize(places.size());
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      p.groups.push_back({i, i, i + 1});
      for (int d = 0; d < 3; ++d) p.x[d][i] = places[i][d];
    }
    const SphereContacts &contacts = system.add(std::make_unique<SphereContacts>(HertzContact(), skin));
    Obstacles<3> &bodies = system.add(
        std::make_unique<Obstacles<3>>("body", SphereOnSurface{{.friction = 4.}}, std::move(shape)));
    if (listed) bodies.listed_in(contacts.contact_list());
    p.field("radius").assign(p.size(), 0.25);
    p.field("modulus").assign(p.size(), 100.);
    bodies[0].velocity = Vector<3>(0.3, -0.2, 0.1);
    bodies[0].spin = Vector<3>(0.1, 0.2, 0.4);
    SystemMotion<3> motion(system, {.tolerance = 1e-6});
    motion.medium.assign(p.size(), medium);
    Overdamped<3> stepper({.method = OverdampedMethod::heun, .tolerance = 0.02, .first_step = 1e-3}, motion,
                          threads);
    for (double t = 0.; t < 0.5;) {
      const double h = stepper.step(p, 0.02);
      system.advance(h);
      t += h;
    }
    system.compute_forces();
    return Outcome{p.x, bodies[0].force(), listed ? contacts.contact_list()->next_to(0).size() : p.size(),
                   p.size()};
  };
  const Outcome all = go(false, 1), one = go(true, 1), two = go(true, 2);
  BOOST_TEST(all.force.norm() > 0.);
  BOOST_TEST(one.looked_at > 20u);
  BOOST_TEST(10 * one.looked_at < 3 * one.cells);
  for (const Outcome *other : {&one, &two}) {
    BOOST_CHECK(other->x == all.x);
    BOOST_CHECK(other->force == all.force);
  }
}

BOOST_AUTO_TEST_SUITE_END()
