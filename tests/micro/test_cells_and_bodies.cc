// Two kinds of bodies in one scene: centre-based cells and a triangulated rigid body that moves, in one system of particles, stepped by the
// one over-damped stepper, their velocities by the one matrix of motion.
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/geometry/triangulated_body.h"
#include "micro/terms/obstacles.h"
#include "micro/terms/sphere_contacts.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

using namespace turgor;

namespace
{
constexpr double R = 0.35, medium = 5., speed = 0.1;
const auto digits = [](const double relative) { return boost::test_tools::tolerance(relative); };

/// A cube |x| < 1/2 and two cells in a row before its face x = 1/2, all of them touching.
struct Row
{
  ParticleSystem<3> system;
  Particles<3> &p = system.particles;
  SphereContacts *contacts;
  Obstacles<3> *bodies;
  SystemMotion<3> motion{system, {.tolerance = 1e-12}};

  Row(const double between_cells, const double with_body)
  {
    TriangleMesh mesh;
    mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    std::vector<Vector<3>> nodes; // bits of the number: x, y, z
    for (int k = 0; k < 8; ++k)
      nodes.emplace_back((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5);
    p.resize(2);
    p.groups = {{0, 0, 1}, {1, 1, 2}};
    contacts = &system.add(std::make_unique<SphereContacts>(HertzContact(), 0.1));
    contacts->friction = {.normal = between_cells, .tangential = between_cells};
    bodies = &system.add(std::make_unique<Obstacles<3>>("body", SphereOnSurface{{.friction = with_body}},
                                                        std::make_unique<TriangulatedBody>(mesh, nodes, ParticlesAre::outside)));
    p.field("radius") = {R, R};
    p.field("modulus") = {100., 100.};
    p.x[0] = {0.5 + 0.9 * R, 0.5 + 2.8 * R};
    p.x[1] = {0.1, 0.1};
    p.x[2] = {0.05, 0.05};
    motion.medium = {medium, medium};
  }

  /// The body moves along the row for so long that nothing changes any more, in steps of at most `longest` (s). Returns it.
  const Obstacle<3> &push(const OverdampedMethod method, const double longest)
  {
    Obstacle<3> &body = (*bodies)[0];
    body.velocity = Vector<3>(speed, 0., 0.);
    Overdamped<3> stepper({.method = method, .tolerance = 1e-3, .first_step = 1e-3}, motion, 1);
    for (double t = 0.; t < 20.;)
      {
        const double h = stepper.step(p, longest);
        system.advance(h);
        t += h;
      }
    system.compute_forces();
    return body;
  }
};
} // namespace

BOOST_TEST_DONT_PRINT_LOG_VALUE(turgor::OverdampedMethod)

BOOST_AUTO_TEST_SUITE(cells_and_bodies)

// Pushed along, both cells come to move as fast as the body does: it bears the drag of two, and the first hands on that of one.
BOOST_DATA_TEST_CASE(a_body_pushes_a_row_of_cells, boost::unit_test::data::make({OverdampedMethod::euler, OverdampedMethod::implicit}), method)
{
  Row row(3., 4.);
  const Obstacle<3> &body = row.push(method, 0.02);
  for (const std::size_t i : {0, 1})
    BOOST_TEST(row.p.v[0][i] == speed, digits(1e-4));
  BOOST_TEST(body.pressing() == 2. * medium * speed, digits(1e-3));
  BOOST_TEST(row.contacts->contacts()[0].force == medium * speed, digits(1e-3));
  BOOST_CHECK_SMALL(body.force()[0] + row.p.f[0][0] + row.p.f[0][1], 1e-12); // what it pushes with pushes back
}

// Bodies move between steps: the second stage of heun sees them where they were, which makes it of first order in their motion.
BOOST_AUTO_TEST_CASE(heun_sees_a_moving_body_to_first_order)
{
  const auto error = [](const double longest) {
    Row row(3., 4.);
    return row.push(OverdampedMethod::heun, longest).pressing() / (2. * medium * speed) - 1.;
  };
  const double coarse = error(0.02), fine = error(0.01);
  BOOST_CHECK_SMALL(fine, 0.02);
  BOOST_TEST(coarse / fine == 2., digits(0.1));
}

// A body that slides along the row drags the first cell by friction, and that the second: two equations by hand.
BOOST_AUTO_TEST_CASE(a_body_that_slides_by_drags_the_cells)
{
  Row row(30., 40.);
  (*row.bodies)[0].velocity = Vector<3>(0., speed, 0.);
  row.motion.forces(row.p, false);
  row.motion.velocities(row.p, 0.);
  double with_body = 0.;
  row.bodies->for_touches(row.p, [&](std::size_t, const auto &, const SphereContact &c) { with_body += 40. * c.area; });
  const double between = 30. * row.contacts->contacts()[0].area;
  BOOST_TEST(with_body > 0.);
  BOOST_TEST(between > 0.);
  const double first = with_body * speed / (medium + with_body + between - between * between / (medium + between));
  BOOST_TEST(row.p.v[1][0] == first, digits(1e-9));
  BOOST_TEST(row.p.v[1][1] == between * first / (medium + between), digits(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
